// The SIMD code of the search in wide trees, compiled once for every target. The code takes and
// returns plain values.
#pragma once

#include "common/pair/triangle_pair.hpp"
#include "common/tree/wide/pair_buckets.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace cd {

/// B's pose in A's coordinates, with the margins that its errors require; wide_kernel.cpp derives
/// both margins.
struct WidePose {
    std::array<double, 9> rotation{}; ///< Row-major.
    std::array<double, 3> translation{};
    alignas(16) std::array<std::array<float, 4>,
                           3> columns{}; ///< Columns of `rotation`. The fourth entry is 0.
    alignas(16)
        std::array<std::array<float, 4>, 3> rows{}; ///< Rows of `rotation`. The fourth entry is 0.
    float relative_margin = 0; ///< Relative to the sum of the sizes and the distance of two nodes.
    float absolute_margin = 0; ///< A length; includes the reach.
    float reach = 0;           ///< Pairs of children that are farther apart are of no interest.
    /// A direction: a unit vector in A's coordinates, and the same in B's; zero if there is none.
    /// A descent for the nearest pair compares projections on it, too. The fourth entries are 0.
    std::array<float, 4> along{};
    std::array<float, 4> along_in_b{};
    /// Ranks of a descent for the nearest pair: that of a distance is the leading bits of its
    /// square, as a float stores them, less this number.
    std::int32_t rank_base = 0;
};

/// The number of low bits of a float that its rank leaves out: distances of one rank differ by less
/// than 23 %.
inline constexpr int rank_shift = 22;

/// Returns the square of the least distance whose rank is `rank`, which is above 0.
[[nodiscard]] inline float least_square_of(std::int32_t rank, const WidePose& pose) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(rank + pose.rank_base) << rank_shift);
}

/// The most pairs of nodes that are visited together.
inline constexpr std::size_t wide_batch_max = 8;

/// The most pairs of leaves that are set aside.
inline constexpr std::size_t wide_leaves_max = 64;

/// Room behind the waiting pairs: the most pairs that a batch can add, and the elements that are
/// written beyond them.
inline constexpr std::size_t wide_pairs_slack =
    wide_batch_max * wide_children_max * wide_children_max + wide_children_max;

/// A tree as the descent reads it, with vertices of one precision.
struct WideBody {
    const WideNode* nodes = nullptr;
    const float* floats = nullptr; ///< See TriangleBlocks for the layout of the vertices.
    const double* doubles = nullptr;
    const std::uint32_t* vertex_begin = nullptr;
    const BlockCorners* corners = nullptr;
};

/// The state of a descent of two wide trees.
struct WideWalk {
    WideBody a;
    WideBody b;
    WidePair* waiting = nullptr; ///< Pairs whose boxes may overlap; the last one is next.
    std::size_t waiting_count = 0;
    std::size_t waiting_room = 0;
    Candidate* candidates = nullptr; ///< Has room for `wide_pairs_slack` more than wanted.
    std::size_t candidate_count = 0;
    std::size_t candidates_wanted = 0;
    std::array<WidePair, wide_leaves_max> leaves; ///< Pairs of leaves that are set aside.
    std::size_t leaf_count = 0;
    /// Number of pairs of leaves that are set aside before they are visited; at most
    /// `wide_leaves_max` - `wide_batch_max`.
    std::size_t leaves_at_once = 0;
    PairBuckets ranked;            ///< The waiting pairs of `walk_wide_ranked`.
    std::uint32_t visits_left = 0; ///< Visits left before the descent pauses.
    std::uint64_t visits = 0;      ///< Pairs of nodes visited so far.
    std::uint64_t box_tests = 0;
};

/// Continues the descent until no pair waits, enough candidates are found, no visits are left, or
/// the waiting pairs lack room for `wide_pairs_slack` more.
void walk_wide(const WidePose& pose, WideWalk& walk);

/// Visits the pairs in `ranked` singly, the most promising first, until one of the conditions of
/// `walk_wide` holds. Sets no leaves aside.
void walk_wide_ranked(const WidePose& pose, WideWalk& walk);

/// Does the same, but the nearest pairs come first: their rank is that of a lower bound of the
/// distance of their boxes. Leaves out pairs that are farther apart than the reach in the space of
/// either node's frame, or along the pose's direction.
void walk_wide_nearest(const WidePose& pose, WideWalk& walk);

} // namespace cd
