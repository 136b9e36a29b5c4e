// The bodies and the lines of the comparison of shot lines.
#pragma once

#include "bench/peers/shots/shot_engine.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

struct ShotSceneOptions {
    std::filesystem::path models;            ///< Folder of the mesh files.
    std::uint32_t lines = 100000;            ///< Of a grid on each side.
    std::uint32_t lines_on_features = 10000; ///< Through vertices, and through edges.
    int sphere_subdivisions = 6;             ///< Of the generated sphere.
    std::string only;                        ///< Bodies with this in their names.
};

/// A body of the comparison, with its coordinates rounded to floats.
struct ShotTarget {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
};

/// Returns a generated sphere and the models, but for missing files, which are named on stderr.
[[nodiscard]] std::vector<ShotTarget> shot_targets(const ShotSceneOptions& options);

/// Makes the grids of a job that looks at the body from the front, from the left and from above, in
/// tiles of 64 by 64 lines. Some `lines` lines from each side meet the body's box, and the tiles
/// have some more. The spacing has few digits, and the middle of the grid is a multiple of it.
[[nodiscard]] ShotScene grid_scene(const ShotTarget& target, std::uint32_t lines);

/// Makes lines along x, y and z in turn, through at most `count` vertices that triangles use.
[[nodiscard]] ShotScene vertex_scene(const ShotTarget& target, std::uint32_t count);

/// Makes lines along x, y and z in turn, through the middles of at most `count` edges. Edges whose
/// middle's other two coordinates are no floats have no line.
[[nodiscard]] ShotScene edge_scene(const ShotTarget& target, std::uint32_t count);

} // namespace cd::bench
