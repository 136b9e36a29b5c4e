// The scenes of the comparison: real vehicles, generated ones, and those that only scaling is
// measured on.
#pragma once

#include "bench/accuracy/suites/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cd::bench {

struct SceneOptions {
    std::filesystem::path models;    ///< Folder of the mesh files.
    std::filesystem::path scenarios; ///< Folder of the pose files.
    std::size_t poses = 200;         ///< Of a scene, evenly spread over its file if it has one.
    std::size_t scaling_poses = 50;
    std::uint64_t vehicle_triangles = 300000; ///< Of the generated truck; the car has 3 of 10.
    std::uint64_t size_max = 10000000;        ///< The largest truck of the scaling.
};

/// A scene that has not been loaded: not all fit memory at a time.
struct SceneSource {
    std::string suite; ///< "scenes", "size" (by triangles) or "depth" (by penetration).
    std::string name;
    double x = 0; ///< What the suite varies: triangles of both bodies, or share of B's diagonal.
    /// Nothing, and said on stderr, where a file is missing.
    std::function<std::optional<Scene>()> load;
};

[[nodiscard]] std::vector<SceneSource> scene_sources(const SceneOptions& options);

} // namespace cd::bench
