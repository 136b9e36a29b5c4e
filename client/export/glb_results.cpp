#include "client/base/units.hpp"
#include "client/export/body_map.hpp"
#include "client/export/glb_file.hpp"
#include "client/export/result_writer.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cd {

namespace {

/// Grey for triangles that are in no pair of any scenario; then colours of the map viridis
/// (https://bids.github.io/colormap/), evenly spaced, for growing numbers of scenarios.
constexpr std::array<Colour, 16> heat_colours{{{150, 150, 150},
                                               {0x44, 0x01, 0x54},
                                               {0x48, 0x1b, 0x6d},
                                               {0x46, 0x32, 0x7e},
                                               {0x3f, 0x47, 0x88},
                                               {0x36, 0x5c, 0x8d},
                                               {0x2e, 0x6e, 0x8e},
                                               {0x27, 0x7f, 0x8e},
                                               {0x21, 0x91, 0x8c},
                                               {0x1f, 0xa1, 0x87},
                                               {0x2d, 0xb2, 0x7d},
                                               {0x4a, 0xc1, 0x6d},
                                               {0x73, 0xd0, 0x56},
                                               {0xa0, 0xda, 0x39},
                                               {0xd0, 0xe1, 0x1c},
                                               {0xfd, 0xe7, 0x25}}};

/// The triangles of one colour.
struct Heat {
    std::vector<std::uint32_t> triangles;
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max(); ///< Fewest scenarios of one.
    std::uint64_t most = 0;
};

/// Returns the colour of a number of scenarios, on a logarithmic scale up to `most`.
std::size_t colour_of(std::uint64_t scenarios, std::uint64_t most) {
    constexpr std::size_t last = heat_colours.size() - 1;
    if (scenarios == 0) {
        return 0;
    }
    if (scenarios == most) {
        return last;
    }
    const double part =
        std::log(static_cast<double>(scenarios)) / std::log(static_cast<double>(most));
    return 1 + static_cast<std::size_t>(std::round(part * (last - 1)));
}

std::array<Heat, heat_colours.size()> by_colour(const std::vector<std::uint64_t>& scenarios) {
    std::array<Heat, heat_colours.size()> heats;
    const std::uint64_t most = *std::ranges::max_element(scenarios);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        Heat& heat = heats[colour_of(scenarios[i], most)];
        heat.triangles.push_back(static_cast<std::uint32_t>(i));
        heat.least = std::min(heat.least, scenarios[i]);
        heat.most = std::max(heat.most, scenarios[i]);
    }
    return heats;
}

/// Returns a material's name, which serves as the legend: "17 to 32 of 1 000 scenarios".
std::string legend(const Heat& heat, std::uint64_t tested, const ExportContext& context) {
    const std::string numbers = heat.least == heat.most
                                    ? grouped(heat.most)
                                    : grouped(heat.least) + " to " + grouped(heat.most);
    const std::string of =
        context.map_pairs() == 0
            ? ""
            : ", of the first " + grouped(context.map_pairs()) + " pairs a scenario";
    const std::string never = context.clearance ? "never near or in contact" : "never in contact";
    return heat.most == 0 ? never + of : numbers + " of " + grouped(tested) + " scenarios" + of;
}

NumberArray corners_of(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    return make_numbers<std::uint32_t>(3 * triangles.size(), [&](std::uint64_t i) {
        return mesh.triangles()[triangles[i / 3]][i % 3];
    });
}

} // namespace

Status write_glb_bodies(const ContactMap& map,
                        std::uint64_t tested,
                        const std::filesystem::path& dir,
                        const ExportContext& context) {
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        const ExportBody& body = context.bodies[i];
        const auto scenarios = CD_TRY(scenarios_of_triangles(map.bodies[i], *body.mesh));
        const auto heats = by_colour(scenarios);
        GlbMesh mesh{body.name, body.mesh->vertices(), {}};
        GlbScene scene;
        scene.metres = unit_factor(context.unit, "m").value_or(1);
        for (std::size_t colour = 0; colour < heats.size(); ++colour) {
            const Heat& heat = heats[colour];
            if (heat.triangles.empty()) {
                continue;
            }
            mesh.primitives.push_back({GlbPrimitive::Mode::Triangles,
                                       scene.materials.size(),
                                       corners_of(*body.mesh, heat.triangles)});
            scene.materials.push_back({legend(heat, tested, context), heat_colours[colour]});
        }
        scene.meshes.push_back(std::move(mesh));
        const std::string name = body_file_name(context.bodies, i) + ".glb";
        CD_TRY(write_glb(scene, dir / name, context.stop));
    }
    return Done{};
}

} // namespace cd
