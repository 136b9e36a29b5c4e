// The scenes of the comparison: real vehicles, generated ones, and scenes for scaling only.
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
    std::size_t poses = 200; ///< Poses per scene, evenly spread over its file if it has one.
    std::size_t scaling_poses = 50;
    /// Triangles of the generated truck; the car has 3/10 of them.
    std::uint64_t vehicle_triangles = 300000;
    std::uint64_t size_max = 10000000; ///< Triangles of the largest truck for scaling.
};

/// A scene not yet loaded: not all fit into memory together.
struct SceneSource {
    std::string suite; ///< "scenes", or "size" for scaling by triangles.
    std::string name;
    double x = 0; ///< Triangles of both bodies, where their number varies.
    /// Returns nothing, with a line on stderr, if a file is missing.
    std::function<std::optional<Scene>()> load;
};

[[nodiscard]] std::vector<SceneSource> scene_sources(const SceneOptions& options);

} // namespace cd::bench
