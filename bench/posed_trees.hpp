// What a program of measurement on two bodies takes from its command line: their trees, and poses.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd::bench {

struct PosedTreesOptions {
    std::string a;
    std::string b;
    double unit_a = 1;
    std::string poses;         ///< A file; random ones without it.
    std::uint64_t random = 50; ///< How many.

    /// MESH_A MESH_B [--unit-a 1] [--poses FILE | --random 50]
    void add_to(CLI::App& app);
};

struct PosedTrees {
    std::shared_ptr<const Mesh> mesh_a;
    std::shared_ptr<const Mesh> mesh_b;
    ObbTree a;
    ObbTree b;
    std::vector<PosePair> poses; ///< At least one.
};

/// Nothing, and a line on stderr, where a file cannot be read or holds no pose.
[[nodiscard]] std::optional<PosedTrees> load(const PosedTreesOptions& options);

/// The poses of a file, a line each: of B in A's frame, nine numbers of the matrix, row by row,
/// then the translation. Nothing where there is no file, or a line has not 12 numbers.
[[nodiscard]] std::optional<std::vector<PosePair>> read_poses(const std::string& path);

} // namespace cd::bench
