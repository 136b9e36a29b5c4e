// The SIMD code of the search in wide trees, compiled once for every target: plain values in and
// out.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "common/tree/wide/pair_buckets.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// B's pose in A's coordinates, with what its use costs in exactness: wide_kernel.cpp derives both
/// margins.
struct WidePose {
    std::array<double, 9> rotation{}; ///< By rows.
    std::array<double, 3> translation{};
    alignas(16)
        std::array<std::array<float, 4>, 3> columns{}; ///< Of the rotation. The fourth entry is 0.
    alignas(16) std::array<std::array<float, 4>, 3> rows{}; ///< Of the same.
    float relative_margin = 0; ///< Times the sizes and distance of two nodes.
    float absolute_margin = 0;
};

/// The most pairs of nodes that are looked at together.
inline constexpr std::size_t wide_batch_max = 8;

/// The most pairs of leaves that are put aside.
inline constexpr std::size_t wide_leaves_max = 64;

/// The most pairs that a batch can leave behind, and what is written beyond them.
inline constexpr std::size_t wide_pairs_slack =
    wide_batch_max * wide_children_max * wide_children_max + wide_children_max;

/// A tree as the descent reads it, with vertices of one kind.
struct WideBody {
    const WideNode* nodes = nullptr;
    const float* floats = nullptr; ///< As in TriangleBlocks, as are the next three.
    const double* doubles = nullptr;
    const std::uint32_t* vertex_begin = nullptr;
    const BlockCorners* corners = nullptr;
};

/// A descent on its way.
struct WideWalk {
    WideBody a;
    WideBody b;
    WidePair* waiting = nullptr; ///< Pairs whose boxes may overlap; the last one is next.
    std::size_t waiting_count = 0;
    std::size_t waiting_room = 0;
    Candidate* candidates = nullptr; ///< With room for `wide_pairs_slack` beyond those wanted.
    std::size_t candidate_count = 0;
    std::size_t candidates_wanted = 0;
    std::array<WidePair, wide_leaves_max> leaves;
    std::size_t leaf_count = 0;
    /// How many pairs of leaves are put aside until they are looked at: `wide_batch_max` less than
    /// there is room for, or fewer.
    std::size_t leaves_at_once = 0;
    PairBuckets ranked;            ///< What waits for `walk_wide_ranked`.
    std::uint32_t visits_left = 0; ///< Pairs of nodes to look at before the walk pauses.
    std::uint64_t visits = 0;      ///< Pairs of nodes looked at.
    std::uint64_t box_tests = 0;
};

/// Goes on until nothing waits, enough candidates are found, no visits are left, or what waits
/// lacks room for `wide_pairs_slack` more.
void walk_wide(const WidePose& pose, WideWalk& walk);

/// The same of the pairs in `ranked`, one by one, the most promising first. Puts no leaves aside.
void walk_wide_ranked(const WidePose& pose, WideWalk& walk);

} // namespace cd
