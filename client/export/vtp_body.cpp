#include "client/export/vtp_body.hpp"

#include "client/formats/part_finder.hpp"

namespace cd {

namespace {

NumberArray parts_of(const std::shared_ptr<const Mesh>& mesh) {
    return make_numbers<std::int32_t>(
        mesh->triangles().size(), [finder = PartFinder(mesh)](std::uint64_t i) mutable {
            const auto part = finder.find(static_cast<std::uint32_t>(i));
            return part ? static_cast<std::int32_t>(*part) : -1;
        });
}

} // namespace

VtpData
vtp_body(const std::shared_ptr<const Mesh>& mesh, std::span<const Vec3> points, NpyType type) {
    VtpData data;
    data.points = coordinates(points, type);
    data.triangles = triangle_cells(*mesh);
    data.cell_arrays = {
        {"part", parts_of(mesh)},
        {"triangle",
         make_numbers<std::uint32_t>(mesh->triangles().size(), [](std::uint64_t i) { return i; })}};
    VtpTexts names{"part_names", {}};
    for (const Part& part : mesh->parts()) {
        names.texts.push_back(part.name);
    }
    if (!names.texts.empty()) {
        data.texts.push_back(std::move(names));
    }
    return data;
}

} // namespace cd
