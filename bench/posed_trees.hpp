// Command-line options of benchmarks on two bodies: their trees and poses.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
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
    std::string b; ///< Empty: A meets itself.
    double unit_a = 1;
    std::string poses;         ///< A pose file; random poses if empty.
    std::uint64_t random = 50; ///< Number of random poses.
    bool planes = false;       ///< Make the support points of both trees.

    /// MESH_A [MESH_B] [--unit-a 1] [--poses FILE | --random 50] [--planes]
    void add_to(CLI::App& app);
};

struct PosedTrees {
    std::shared_ptr<const Mesh> mesh_a;
    std::shared_ptr<const Mesh> mesh_b;
    ObbTree a;
    ObbTree b;
    std::vector<PosePair> poses; ///< Not empty.
};

/// Returns nothing, with a line on stderr, if a file cannot be read or has no pose.
[[nodiscard]] std::optional<PosedTrees> load(const PosedTreesOptions& options);

/// Reads the poses of B in A's frame, one a line: nine numbers of the matrix, row by row, then the
/// translation. Returns nothing if the file is missing or a line has not 12 numbers.
[[nodiscard]] std::optional<std::vector<PosePair>> read_poses(const std::string& path);

/// Returns `count` poses with 0.5 to 5 % of B's diagonal of penetration, as jobs of kind `random`.
[[nodiscard]] std::vector<PosePair>
random_poses(const ObbTree& a, const ObbTree& b, std::uint64_t count, ThreadPool& pool);

/// Returns the pairs that our box tests leave for the triangle test (the narrow phase's input), by
/// position in the trees.
[[nodiscard]] std::vector<Candidate>
candidates_of(const ObbTree& a, const ObbTree& b, const PosePair& poses);

} // namespace cd::bench
