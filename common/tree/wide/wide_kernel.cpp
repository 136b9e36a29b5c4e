// Why a pair of boxes that this code skips shares no point, and how its margins follow.
//
// Let o, p be the origins of the nodes of A and B, F and G their frames (rows, floats taken as
// exact numbers), and R, t the true relative pose: x = R y + t holds for every point that both
// share. With alpha = F (x - o) and beta = G (y - p),
//     alpha = T + N beta,  beta = N^-1 (alpha - T),  N = F R G^-1,  T = F (R p + t - o).
// A child's box bounds one of alpha and beta; the equations turn it into an interval of the other
// on each axis. Children whose intervals are apart on any axis of either frame share no point.
//
// Bounds, with u = 2^-24, e = axes_error_max = 2 u, r = rotation_error, s = skew, w = R p + t - o,
// |.| the sum of sizes, E the largest coordinates, 255 steps on each axis, of a node.
// (1) w is formed in doubles: within abs = r |p| + translation_error + 2^-49 (|p| + |t| + |o|) in
//     each component; as a float within u |w| more.
// (2) T: three products with entries of at most 1.001, two sums: 5 u |w| + 1.8 abs.
// (3) M for N: |G^-1 - G'| and so on as in box_test.cpp: 3.01 (r + e). In floats, R takes u, its
//     product with G' 3 u, and F's with that 3 u, each times at most 3.03. Below 28 u + 3.01 r.
// (4) M' for N^-1: the squares of N's singular values are within 6.1 e + 3.01 s of 1, so
//     |N^-1 - M'| < 41 u + 3.1 (r + s). N^-1 T = G R^-1 w is formed as G R' w: R' for R^-1 costs
//     3.01 s |w|, R in doubles and then in floats 1.75 r |w| + u |w|, w as a float u |w|, two times
//     three products and two sums 6 u |w|; and w itself errs by abs, 1.8 abs in this direction.
//     Below 9 u |w| + 3.1 (r + s) |w| + 1.8 abs.
// (5) An interval T + M (c +- h), divided by the steps: an entry takes three roundings with the
//     quotient, T two; c and h are whole, sums of four take four, their difference one: within
//     12 u (1.74 |w| + 2 E).
// (6) Errors of boxes' intervals. B's boxes in A's frame, by (2), (3) and (5):
//         26 u |w| + 52 u E_b + 3.01 r E_b + 1.8 abs.
//     A's boxes in B's frame, by (4) and (5):
//         30 u |w| + 65 u E_a + 3.1 (r + s) (|w| + E_a) + 1.8 abs.
// (7) Intervals of triangles, from their corners y (of B; of A likewise): alpha = T + F R (y - p),
//     beta = -G R^-1 w + G R^-1 (x - o). A leaf's origin and its vertices are both floats, so that
//     y - p takes one rounding of each component, or both are doubles, and y - p takes one to a
//     double and one to a float: within (1 + 2^-28) u either way; |y - p| <= 1.74 E. An entry of
//     F R: R as floats one, three products and two sums three, the steps two roundings, each
//     times 1.01, and 1.75 r; R' for R^-1 another 3.01 s |x - o|. Products and sums four, the
//     difference with the margin one: together 12.01 u 1.74 E + (1.75 r + 3.01 s) 1.74 E, and what
//     T has by (2), (4) and (5).
// (8) All errors are below 128 u (|w| + E_a + E_b) + 6 (r + s) (|w| + E_a + E_b) + 4 abs. `margin`
//     is this bound and covers its own roundings and those of |w|. Underflow costs less than 2^-148
//     of a length or an entry, in steps below 2^-20; the margin is at least 255 * 2^-17 steps.
// (9) Reach. Two points within the reach satisfy x = R y + t + z, where |z| is at most the reach in
//     the coordinates of each body. Then alpha differs by F z and beta by G R^-1 z, each at most as
//     long as the reach times 1 + 2 u. So if intervals that are wider by this length are apart, the
//     points are farther apart than the reach. A margin takes four roundings, and sums with it err
//     by below 12 u of it: `set_margin` adds the reach times 1 + 128 u.
// (10) Gaps. The gap of two intervals on an axis, less the reach that widens one of them, bounds
//     from below the displacement along that axis: the error bound of (8) has room for one more
//     rounding of the interval's end. The difference, the product with the step, the sum with the
//     reach and the sum of three squares err by below 10 u, the frame by 6 u. So the sum of
//     squares, times 1 - 2^-14, is at most the square of the distance.
// (11) A direction n, |n| <= 1 + 8 u, as floats, and m = R' n for B, which takes r and a rounding.
//     n (x - o) >= min over A's child of n (x - o), and so on, so the least n (R y + t - x) of two
//     children is n w + min m (y - p) + min -n (x - o). If the points are within the reach, n z is
//     at most the reach times 1 + 8 u. Errors: (1) and n w: abs 1.8 + 6 u |w|. A box: n is turned
//     to the node's frame, 3 u and the frame's 2 e, three products with the steps and two sums:
//     below (3 + 4 + 8) u 3 E. Corners: y - p one rounding, three products and sums, m one and
//     1.75 r: below 8 u 1.74 E + 3.1 r E. All are below the bound of (8), and `Meeting::margin` is
//     that bound with the reach.
//
// Overflow: coordinates of a wide tree are below 2^50, so that boxes are within a reach of
// 2^50 only where |w| is below 2^55; steps are within [2^-70, 2^45]. Then all that is made of an
// interval stays below 2^127 or is a margin. So any other overflow belongs to boxes that are apart.
// An infinite margin and a comparison with NaN both count as no separation.
#include "common/tree/wide/wide_kernel.hpp"

#include "common/core/prefetch.hpp"
#include "common/geometry/highway_targets.hpp"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/wide/wide_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/tree/wide/wide_meeting-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// The state of one node pair of a batch.
struct Visit {
    Meeting meeting;
    Side side_a;
    Side side_b;
    Intervals seen_a;      ///< Intervals of A's children in the frame of B's node.
    Intervals seen_b;      ///< Intervals of B's children in the frame of A's node.
    std::uint32_t found_a; ///< Bit mask of the children of A's node that may overlap B's node.
    std::uint32_t found_b;
    alignas(64) float least_a[children]; ///< Of A's children, against the pose's direction.
    alignas(64) float least_b[children];
};

/// Prefetches the triangles of a leaf, sized for the vertex count that most leaves have.
HWY_INLINE void prefetch_triangles(const WideBody& body, const WideNode& leaf) {
    const std::size_t first = 3 * std::size_t{body.vertex_begin[leaf.first]};
    if (body.floats != nullptr) {
        prefetch(body.floats + first, children * 3 * sizeof(float));
    } else {
        prefetch(body.doubles + first, children * 3 * sizeof(double));
    }
    prefetch(body.corners + std::size_t{block_size} * leaf.first, children * sizeof(BlockCorners));
}

// Pairs of one batch proceed in lockstep: all take one step before any takes the next, so that
// their loads overlap and no branch depends on a single pair. Pairs of leaves are collected until
// there are enough of them.

/// Bit masks of the children of A's node and of B's that a direction does not part.
struct Parting {
    std::uint32_t a;
    std::uint32_t b;
};

/// Projects the children of both nodes on the pose's direction: the sum of a `least_a` and a
/// `least_b` is how far the two children are apart along it. Returns the children that are not
/// farther from all of the other side's than the margin.
template <bool kBothLeaves>
HWY_INLINE Parting project_both(const WidePose& pose, const WideWalk& walk, Visit& visit) {
    const float against[3] = {-pose.along[0], -pose.along[1], -pose.along[2]};
    project<kBothLeaves>(walk.a, visit.side_a, against, 0, visit.least_a);
    project<kBothLeaves>(
        walk.b, visit.side_b, pose.along_in_b.data(), visit.meeting.along, visit.least_b);
    const float least_a = least_of(visit.least_a, visit.side_a.count);
    const float least_b = least_of(visit.least_b, visit.side_b.count);
    return {not_above(visit.least_a, visit.side_a.count, visit.meeting.margin - least_b),
            not_above(visit.least_b, visit.side_b.count, visit.meeting.margin - least_a)};
}

/// Tests the first `count` visits from both sides. Writes to `left` the indices of the visits where
/// both nodes have children that may overlap the other node. Returns the number of these visits.
template <bool kBothLeaves, Rating kRating>
HWY_INLINE std::size_t see_both(
    const WidePose& pose, WideWalk& walk, Visit* visits, std::size_t count, std::size_t* left) {
    std::size_t left_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Visit& now = visits[i];
        const WideNode& a = walk.a.nodes[now.meeting.nodes.a];
        const WideNode& b = walk.b.nodes[now.meeting.nodes.b];
        // While only one node is a leaf, the search descends the other one alone.
        now.side_a = side_of(a, now.meeting.nodes.a, !kBothLeaves && a.is_leaf);
        now.side_b = side_of(b, now.meeting.nodes.b, !kBothLeaves && b.is_leaf);
        walk.box_tests += now.side_b.count;
        Parting parting{children_mask(now.side_a), children_mask(now.side_b)};
        if constexpr (kRating == Rating::Gap) {
            parting = project_both<kBothLeaves>(pose, walk, now);
            if (parting.a == 0) {
                continue;
            }
        }
        now.found_a = parting.a;
        now.found_b =
            see_b<kBothLeaves>(pose, walk.b, a, now.side_b, now.meeting, now.seen_b) & parting.b;
        left[left_count] = i;
        left_count += now.found_b != 0 ? 1 : 0;
    }
    std::size_t both_count = 0;
    for (std::size_t i = 0; i < left_count; ++i) {
        Visit& now = visits[left[i]];
        const WideNode& b = walk.b.nodes[now.meeting.nodes.b];
        walk.box_tests += now.side_a.count;
        now.found_a &= see_a<kBothLeaves>(pose, walk.a, b, now.side_a, now.meeting, now.seen_a);
        left[both_count] = left[i];
        both_count += now.found_a != 0 ? 1 : 0;
    }
    return both_count;
}

/// The two sides of a visit. Each row is a found child of `one`, the side with fewer found ones.
struct Rows {
    RowSide one;
    RowSide others;
    bool one_is_a;
};

HWY_INLINE Rows rows_of(const Visit& visit, std::uint64_t& box_tests) {
    const RowSide of_a{visit.side_a, visit.seen_a, visit.found_a, visit.least_a};
    const RowSide of_b{visit.side_b, visit.seen_b, visit.found_b, visit.least_b};
    const int rows_a = __builtin_popcount(visit.found_a);
    const int rows_b = __builtin_popcount(visit.found_b);
    const bool by_a = rows_a <= rows_b;
    box_tests += static_cast<std::uint64_t>(by_a ? rows_a : rows_b) *
                 (by_a ? visit.side_b.count : visit.side_a.count);
    return {by_a ? of_a : of_b, by_a ? of_b : of_a, by_a};
}

/// Processes the first `count` visits and writes the pairs of children that may overlap to `to`.
/// Returns the number of these pairs.
template <bool kBothLeaves, Rating kRating>
HWY_INLINE std::size_t
look_at(const WidePose& pose, WideWalk& walk, Visit* visits, std::size_t count, std::uint32_t* to) {
    std::size_t left[wide_batch_max];
    const std::size_t left_count = see_both<kBothLeaves, kRating>(pose, walk, visits, count, left);
    std::size_t written = 0;
    for (std::size_t i = 0; i < left_count; ++i) {
        Visit& now = visits[left[i]];
        const Rows rows = rows_of(now, walk.box_tests);
        written += pair_up<kRating>(
            rows.one, rows.others, rows.one_is_a, pose, now.meeting.margin, to + 2 * written);
    }
    return written;
}

HWY_INLINE void count_visits(WideWalk& walk, std::size_t count) {
    walk.visits += count;
    walk.visits_left -= std::min(walk.visits_left, static_cast<std::uint32_t>(count));
}

/// Prepares visits of pairs of nodes but sets pairs of leaves aside. Returns the number of prepared
/// visits.
HWY_INLINE std::size_t meet_inner(
    const WidePose& pose, WideWalk& walk, const WidePair* now, std::size_t count, Visit* visits) {
    for (std::size_t i = 0; i < count; ++i) {
        prefetch(walk.a.nodes + now[i].a, sizeof(WideNode));
        prefetch(walk.b.nodes + now[i].b, sizeof(WideNode));
    }
    std::size_t inner = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const WideNode& a = walk.a.nodes[now[i].a];
        const WideNode& b = walk.b.nodes[now[i].b];
        if (a.is_leaf && b.is_leaf) {
            prefetch_triangles(walk.a, a);
            prefetch_triangles(walk.b, b);
            walk.leaves[walk.leaf_count++] = now[i];
        } else {
            meet(pose, a, b, now[i], visits[inner++].meeting);
        }
    }
    return inner;
}

/// Visits one batch of the waiting pairs.
HWY_INLINE void visit_inner(const WidePose& pose, WideWalk& walk, Visit* visits) {
    const std::size_t count = std::min(walk.waiting_count, wide_batch_max);
    walk.waiting_count -= count;
    const WidePair* now = walk.waiting + walk.waiting_count;
    const std::size_t inner = meet_inner(pose, walk, now, count, visits);
    auto* to = reinterpret_cast<std::uint32_t*>(walk.waiting + walk.waiting_count);
    walk.waiting_count += look_at<false, Rating::None>(pose, walk, visits, inner, to);
    count_visits(walk, inner);
}

/// Visits one batch of the pairs of leaves.
template <Rating kRating>
HWY_INLINE void visit_leaves(const WidePose& pose, WideWalk& walk, Visit* visits) {
    const std::size_t count = std::min(walk.leaf_count, wide_batch_max);
    walk.leaf_count -= count;
    for (std::size_t i = 0; i < count; ++i) {
        const WidePair now = walk.leaves[walk.leaf_count + i];
        meet(pose, walk.a.nodes[now.a], walk.b.nodes[now.b], now, visits[i].meeting);
    }
    auto* to = reinterpret_cast<std::uint32_t*>(walk.candidates + walk.candidate_count);
    walk.candidate_count += look_at<true, kRating>(pose, walk, visits, count, to);
    count_visits(walk, count);
}

/// Visits the most promising pair.
template <Rating kRating>
HWY_INLINE void visit_ranked(const WidePose& pose, WideWalk& walk, Visit& visit) {
    const WidePair now = walk.ranked.pop();
    const std::size_t inner = meet_inner(pose, walk, &now, 1, &visit);
    std::size_t left = 0;
    if (see_both<false, kRating>(pose, walk, &visit, inner, &left) > 0) {
        const Rows rows = rows_of(visit, walk.box_tests);
        rank_pairs<kRating>(
            rows.one, rows.others, rows.one_is_a, pose, visit.meeting.margin, walk.ranked);
    }
    count_visits(walk, inner);
    if (walk.leaf_count > 0) {
        visit_leaves<kRating == Rating::Gap ? Rating::Gap : Rating::None>(pose, walk, &visit);
    }
}

template <Rating kRating>
HWY_INLINE void walk_by_rank(const WidePose& pose, WideWalk& walk) {
    Visit visit;
    while (walk.visits_left > 0 && walk.candidate_count < walk.candidates_wanted &&
           walk.ranked.size() > 0) {
        visit_ranked<kRating>(pose, walk, visit);
    }
}

void walk_ranked(const WidePose& pose, WideWalk& walk) {
    walk_by_rank<Rating::Overlap>(pose, walk);
}

void walk_nearest(const WidePose& pose, WideWalk& walk) {
    walk_by_rank<Rating::Gap>(pose, walk);
}

void walk_all(const WidePose& pose, WideWalk& walk) {
    Visit visits[wide_batch_max];
    while (walk.visits_left > 0 && walk.candidate_count < walk.candidates_wanted &&
           walk.waiting_count + wide_pairs_slack <= walk.waiting_room) {
        if (walk.leaf_count >= walk.leaves_at_once ||
            (walk.waiting_count == 0 && walk.leaf_count > 0)) {
            visit_leaves<Rating::None>(pose, walk, visits);
        } else if (walk.waiting_count > 0) {
            visit_inner(pose, walk, visits);
        } else {
            return;
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(walk_all);
HWY_EXPORT(walk_ranked);
HWY_EXPORT(walk_nearest);

void walk_wide(const WidePose& pose, WideWalk& walk) {
    HWY_DYNAMIC_DISPATCH(walk_all)(pose, walk);
}

void walk_wide_ranked(const WidePose& pose, WideWalk& walk) {
    HWY_DYNAMIC_DISPATCH(walk_ranked)(pose, walk);
}

void walk_wide_nearest(const WidePose& pose, WideWalk& walk) {
    HWY_DYNAMIC_DISPATCH(walk_nearest)(pose, walk);
}

} // namespace cd

#endif
