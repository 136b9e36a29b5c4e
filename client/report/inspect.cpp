#include "client/report/inspect.hpp"

#include "web/status/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cd {

namespace {

constexpr std::size_t parts_shown_max = 20;

/// Guesses the unit of a mesh from its longest edge, assuming that vehicles and parts are
/// centimetres to tens of metres long. The text is empty if several units are likely.
std::string guess_unit(double longest_edge) {
    if (longest_edge >= 0.1 && longest_edge <= 40) {
        return "metres";
    }
    if (longest_edge > 500 && longest_edge <= 40'000) {
        return "millimetres";
    }
    if (longest_edge > 40 && longest_edge <= 500) {
        return "inches or centimetres";
    }
    return {};
}

std::string describe_surface(const Topology& t) {
    if (t.is_closed()) {
        return "closed";
    }
    return fmt::format("open: {} boundary, {} non-manifold, {} inconsistent edges",
                       t.boundary_edges,
                       t.non_manifold_edges,
                       t.inconsistent_edges);
}

std::vector<double> to_list(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace

MeshReport inspect_mesh(const std::string& file, const ImportedMesh& imported) {
    MeshReport report;
    report.file = file;
    report.imported = imported;
    report.box = bounding_box(report.mesh().vertices());
    report.unit_guess = guess_unit(report.box.size().maxCoeff());
    report.topology = analyse_topology(report.mesh());
    return report;
}

std::string to_text(const MeshReport& r) {
    const Vec3 size = r.box.size();
    std::string text = fmt::format("{}\n", r.file);
    const auto line = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<12} {}\n", name, value);
    };
    line("triangles", fmt::format("{}", r.mesh().triangles().size()));
    line("vertices",
         fmt::format("{} distinct, {}",
                     r.mesh().vertices().size(),
                     r.mesh().precision() == Precision::Float ? "float" : "double"));
    line("size", fmt::format("{:.6g} x {:.6g} x {:.6g}", size.x(), size.y(), size.z()));
    line("box",
         fmt::format("[{:.7g}, {:.7g}, {:.7g}] to [{:.7g}, {:.7g}, {:.7g}]",
                     r.box.min.x(),
                     r.box.min.y(),
                     r.box.min.z(),
                     r.box.max.x(),
                     r.box.max.y(),
                     r.box.max.z()));
    line("unit",
         r.unit_guess.empty() ? "cannot be told from the size" : "by its size: " + r.unit_guess);
    for (const std::string& note : r.notes) {
        line("file", note);
    }
    line("surface", describe_surface(r.topology));
    line("components", fmt::format("{}", r.topology.component_triangles.size()));
    line("degenerate", fmt::format("{} triangles, kept", r.topology.degenerate));
    line("duplicate", fmt::format("{} triangles, kept", r.topology.duplicate));
    if (r.imported.points_skipped + r.imported.lines_skipped != 0) {
        line("skipped",
             fmt::format(
                 "{} points, {} lines", r.imported.points_skipped, r.imported.lines_skipped));
    }
    line("parts", fmt::format("{}", r.mesh().parts().size()));
    for (std::size_t i = 0; i < std::min(r.mesh().parts().size(), parts_shown_max); ++i) {
        const Part& part = r.mesh().parts()[i];
        text += fmt::format(
            "    {:<28} {:>9} triangles\n", part.name, part.triangles_end - part.triangles_begin);
    }
    if (r.mesh().parts().size() > parts_shown_max) {
        text += fmt::format("    and {} more; all with -o json\n",
                            r.mesh().parts().size() - parts_shown_max);
    }
    line("hash", to_hex(r.mesh().hash()));
    for (const std::string& warning : r.imported.warnings) {
        line("warning", warning);
    }
    return text;
}

std::string to_json(const MeshReport& r) {
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (const Part& part : r.mesh().parts()) {
        parts.push_back({{"name", part.name},
                         {"first_triangle", part.triangles_begin},
                         {"triangles", part.triangles_end - part.triangles_begin}});
    }
    const nlohmann::ordered_json json{
        {"file", r.file},
        {"triangles", r.mesh().triangles().size()},
        {"vertices", r.mesh().vertices().size()},
        {"precision", r.mesh().precision() == Precision::Float ? "float" : "double"},
        {"box", {{"min", to_list(r.box.min)}, {"max", to_list(r.box.max)}}},
        {"unit_guess", r.unit_guess},
        {"declared_unit", r.imported.declared.unit},
        {"declared_metres", r.imported.declared.metres},
        {"declared_up", r.imported.declared.up},
        {"notes", r.notes},
        {"closed", r.topology.is_closed()},
        {"boundary_edges", r.topology.boundary_edges},
        {"non_manifold_edges", r.topology.non_manifold_edges},
        {"inconsistent_edges", r.topology.inconsistent_edges},
        {"components", r.topology.component_triangles.size()},
        {"degenerate", r.topology.degenerate},
        {"duplicate", r.topology.duplicate},
        {"points_skipped", r.imported.points_skipped},
        {"lines_skipped", r.imported.lines_skipped},
        {"parts", parts},
        {"warnings", r.imported.warnings},
        {"hash", to_hex(r.mesh().hash())}};
    return json_text(json);
}

} // namespace cd
