// Why nodes that `separate` parts share no point, and how its margin follows.
//
// Let c, d be the centres of A and B, and R, t the true relative pose: x = R y + t holds for every
// point that both bodies share, so that (x - c) = R (y - d) + s with s = R d + t - c. Let S be A's
// support points and Q be B's, as floats; each vertex below A's node, less c, is within eps_a of
// the hull of S, but for its rounding, and B's likewise. Let n be any vector. If x is in A's node,
//     n (x - c) <= max over S of n p + eps_a |n|;
// if y is in B's node,
//     n (R (y - d) + s) >= min over Q of (R'n) q - eps_b |R'n| + n s.
// So the nodes share no point if the gap, min (R'n) q + n s - max n p, exceeds
// eps_a |n| + eps_b |R'n|. This holds for every n, however it was found.
//
// Bounds, with u = 2^-24, r = rotation_error, P and Q the radii of A and B, and errors for each
// unit of |n|. `separate` makes |n| < 1 + 8 u, and entries of R are below 1.01.
// (1) A point less its centre takes one rounding of each component, or one to a double and one to
//     a float: within 1.01 u P of its exact place.
// (2) n p: three products and two sums: 3.1 u P. So the largest rounded n p is within this of the
//     largest exact one. A child is skipped if its box is nearer than a point that was found. The
//     box's bound is n (o - c) + sum of w_k b_k with the node's origin o, bytes b_k and
//     w = steps (F n); it may fall short of the exact one by u |o - c| for o - c, 5.1 u |o - c| for
//     the first product and sums, and (3.1 + 1 + 3.1 + e / u) u times the sizes of the steps' sums,
//     below 3 P: below 6.2 u P + 28 u P. So a skipped point costs at most 34.2 u P more.
// (3) m = R'n in floats: R takes u and r for each entry, and three products and two sums 3.1 u:
//     (4.2 u + r) |n|_1 in each component, with |n|_1 < 1.74 |n|: |m - R'n| < (12.7 u + 3.1 r) |n|.
//     So m q is within (12.7 u + 3.1 r) Q + 3.2 u Q of (R'n) q, and (1) costs 1.1 u Q.
// (4) s is formed in doubles, within abs = translation_error + r |d|_1 + 2^-49 (|d|_1 + |t| + |c|)
//     in each component, then rounded to floats: within 1.8 abs + u |s|; n s: 3.1 u |s|.
// (5) The two sums of the gap: 2.1 u (P + 1.02 Q + |s|).
// Together below 41 u P + (54 u + 3.1 r) Q + 8 u |s| + 1.8 abs. `margin` is this bound.
// (6) |R'n| <= (1 + 1.6 skew) |n|, and skew is below 2^-10.
// (7) If y is within a distance z of x, that is x = R y + t + v with |v| <= z, then n v is at most
//     |n| z. So the gap has to exceed z as well; the factor of `needed` covers its roundings.
// Underflow costs less than 2^-120.
//
// Overflow: coordinates of a wide tree are below 2^50. If |s| is beyond 2^100, or a bound is
// infinite, or NaN, the margin is infinite and nothing is parted. A comparison with NaN parts
// nothing either.
#include "common/tree/planes/plane_kernel.hpp"

#include "common/core/prefetch.hpp"
#include "common/geometry/highway_targets.hpp"
#include "common/tree/planes/support_view.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/planes/plane_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/tree/planes/plane_supports-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// Returns by how much a gap between two nodes must be exceeded. 1.002 covers (6), and the other
/// factor the length of n and the roundings of this sum.
HWY_INLINE float needed_gap(const PlanePose& pose,
                            const PlaneBody& a,
                            std::uint32_t node_a,
                            const PlaneBody& b,
                            std::uint32_t node_b) {
    return 1.00001F * (a.sets[node_a].eps + 1.002F * b.sets[node_b].eps + pose.margin + pose.reach);
}

/// Sets `back` to -n in B's coordinates.
HWY_INLINE void turn_back(const PlanePose& pose, const float* n, float* back) {
    const float* r = pose.rotation.data();
    for (std::size_t k = 0; k < 3; ++k) {
        back[k] = -(r[k] * n[0] + r[3 + k] * n[1] + r[6 + k] * n[2]);
    }
}

/// Turns a normal, by the method of Chung and Wang, that did not part two nodes with these support
/// points. Returns false if the points coincide or numbers overflow.
HWY_INLINE bool
turn_normal(const PlanePose& pose, const Support& of_a, const Support& of_b, float* n) {
    const float* r = pose.rotation.data();
    const float* s = pose.translation.data();
    float apart[3]; // From A's support point to B's.
    for (std::size_t i = 0; i < 3; ++i) {
        apart[i] = dot(r + 3 * i, of_b.point) + s[i] - of_a.point[i];
    }
    const float square = dot(apart, apart);
    const float turn = 2 * dot(apart, n) / square;
    float next[3];
    for (std::size_t i = 0; i < 3; ++i) {
        next[i] = n[i] - turn * apart[i];
    }
    const float length = std::sqrt(dot(next, next));
    if (!(square > 0x1p-100F) || !(length > 0.5F) || !(length < 2)) {
        return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        n[i] = next[i] / length;
    }
    return true;
}

float part(const PlanePose& pose,
           const PlaneBody& a,
           std::uint32_t node_a,
           const PlaneBody& b,
           std::uint32_t node_b,
           std::uint32_t steps,
           float* n) {
    const float needed = needed_gap(pose, a, node_a, b, node_b);
    for (std::uint32_t step = 0; step < steps; ++step) {
        const Support of_a = support_of(a, node_a, n);
        float back[3];
        turn_back(pose, n, back);
        const Support of_b = support_of(b, node_b, back);
        const float gap = (dot(n, pose.translation.data()) - of_b.reach) - of_a.reach;
        if (gap > needed) {
            return gap - needed;
        }
        if (!turn_normal(pose, of_a, of_b, n)) {
            return 0;
        }
    }
    return 0;
}

/// Nodes with one parent, or one node, and the support points of those that are wanted.
struct Siblings {
    std::uint32_t first;
    std::uint32_t wanted = 0; ///< A bit for each node, counted from `first`.
    Support support[wide_children_max];

    [[nodiscard]] HWY_INLINE const Support& of(std::uint32_t node) const {
        return support[node - first];
    }
};

/// Finds the siblings among the nodes of pairs.
template <class NodeOf>
HWY_INLINE void find_siblings(std::span<const WidePair> pairs,
                              NodeOf node_of,
                              const SupportSet* sets,
                              Siblings& siblings) {
    siblings.first = node_of(pairs[0]);
    for (const WidePair pair : pairs) {
        siblings.first = std::min(siblings.first, node_of(pair));
    }
    prefetch(sets + siblings.first, wide_children_max * sizeof(SupportSet));
    for (const WidePair pair : pairs) {
        siblings.wanted |= std::uint32_t{1} << (node_of(pair) - siblings.first);
    }
}

HWY_INLINE void prefetch_points(const PlaneBody& body, const Siblings& siblings) {
    for (std::uint32_t rest = siblings.wanted; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        const SupportSet& set = body.sets[siblings.first + i];
        const std::size_t first = 3 * std::size_t{set.first};
        if (set.is_chosen) {
            prefetch(body.columns + first, 3 * padded(set.count) * sizeof(float));
        } else if (body.floats != nullptr) {
            prefetch(body.floats + first, 3 * std::size_t{set.count} * sizeof(float));
        } else {
            prefetch(body.doubles + first, 3 * std::size_t{set.count} * sizeof(double));
        }
    }
}

HWY_INLINE void find_supports(const PlaneBody& body, const float* direction, Siblings& siblings) {
    for (std::uint32_t rest = siblings.wanted; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(rest));
        const SupportSet& set = body.sets[siblings.first + i];
        siblings.support[i] = set.is_chosen ? support_of_chosen(body, set, direction)
                                            : support_of_vertices(body, set, direction);
    }
}

/// Tries a normal on all pairs. Fetches the nodes of those that it does not part, which are looked
/// at next.
HWY_INLINE void find_slacks(const PlanePose& pose,
                            const PlaneBody& a,
                            const PlaneBody& b,
                            std::span<const WidePair> pairs,
                            const float* n,
                            Siblings& of_a,
                            Siblings& of_b,
                            PlaneTrial* trials) {
    float back[3];
    turn_back(pose, n, back);
    find_supports(a, n, of_a);
    find_supports(b, back, of_b);
    const float between = dot(n, pose.translation.data());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const WidePair pair = pairs[i];
        const float gap = (between - of_b.of(pair.b).reach) - of_a.of(pair.a).reach;
        const float slack = gap - needed_gap(pose, a, pair.a, b, pair.b);
        trials[i] = {{n[0], n[1], n[2]}, slack, slack > 0};
        if (!trials[i].is_apart) {
            prefetch(a.nodes + pair.a, sizeof(WideNode));
            prefetch(b.nodes + pair.b, sizeof(WideNode));
        }
    }
}

/// Tries one normal on all pairs, then improved ones on each pair that it does not part, unless
/// both nodes are leaves.
void part_siblings(const PlanePose& pose,
                   const PlaneBody& a,
                   const PlaneBody& b,
                   std::span<const WidePair> pairs,
                   std::uint32_t steps,
                   const float* n,
                   PlaneTrial* trials) {
    Siblings of_a;
    Siblings of_b;
    find_siblings(
        pairs, [](WidePair pair) { return pair.a; }, a.sets, of_a);
    find_siblings(
        pairs, [](WidePair pair) { return pair.b; }, b.sets, of_b);
    prefetch_points(a, of_a);
    prefetch_points(b, of_b);
    find_slacks(pose, a, b, pairs, n, of_a, of_b, trials);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const WidePair pair = pairs[i];
        PlaneTrial& trial = trials[i];
        if (trial.is_apart || (a.nodes[pair.a].is_leaf && b.nodes[pair.b].is_leaf)) {
            continue;
        }
        float* normal = trial.normal.data();
        trial.is_apart = turn_normal(pose, of_a.of(pair.a), of_b.of(pair.b), normal) &&
                         part(pose, a, pair.a, b, pair.b, steps - 1, normal) > 0;
    }
}

std::uint32_t
farthest(const float* columns, std::uint32_t count, const std::array<float, 3>& direction) {
    return farthest_of(columns, count, direction.data()).number;
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "common/geometry/simd_target.hpp"

namespace cd {

HWY_EXPORT(part);
HWY_EXPORT(part_siblings);
HWY_EXPORT(farthest);

PlaneBody::PlaneBody(const WideView& tree)
    : nodes(tree.nodes.data()),
      sets(tree.support.sets.data()),
      columns(tree.support.columns.data()),
      floats(tree.triangles.floats.empty() ? nullptr : tree.triangles.floats.data()),
      doubles(tree.triangles.doubles.empty() ? nullptr : tree.triangles.doubles.data()),
      center(tree.support.center),
      id(tree.support.id) {}

PlanePose plane_pose(const RelativePose& b_to_a,
                     const SupportView& a,
                     const SupportView& b,
                     double error_scale,
                     double reach) {
    constexpr double u = 0x1p-24;
    constexpr double pose_error_max = 0x1p-10;
    const Vec3 c(a.center[0], a.center[1], a.center[2]);
    const Vec3 d(b.center[0], b.center[1], b.center[2]);
    const Vec3 s = b_to_a.rotation * d + b_to_a.translation - c;
    PlanePose pose;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            pose.rotation[static_cast<std::size_t>(3 * i + k)] =
                static_cast<float>(b_to_a.rotation(i, k));
        }
        pose.translation[static_cast<std::size_t>(i)] = static_cast<float>(s[i]);
    }
    const double sizes = d.cwiseAbs().sum();
    const double r = b_to_a.rotation_error;
    const double absolute = b_to_a.translation_error + r * sizes +
                            0x1p-49 * (sizes + b_to_a.translation.norm() + c.norm());
    const double margin = error_scale * (41 * u * a.radius + (54 * u + 3.1 * r) * b.radius +
                                         8 * u * s.norm() + 1.8 * absolute);
    const bool is_bounded = r <= pose_error_max && b_to_a.skew <= pose_error_max &&
                            s.norm() < 0x1p100 && margin < 0x1p100;
    pose.margin = is_bounded ? static_cast<float>(margin) + 0x1p-120F
                             : std::numeric_limits<float>::infinity();
    pose.reach = static_cast<float>(std::min(reach, 0x1p100));
    return pose;
}

PlaneNormal first_normal(const PlanePose& pose) {
    const auto& s = pose.translation;
    const float length = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    return length > 0x1p-50F && length < std::numeric_limits<float>::infinity()
               ? PlaneNormal{s[0] / length, s[1] / length, s[2] / length}
               : PlaneNormal{1, 0, 0};
}

float separate(const PlanePose& pose,
               const PlaneBody& a,
               std::uint32_t node_a,
               const PlaneBody& b,
               std::uint32_t node_b,
               std::uint32_t steps,
               PlaneNormal& normal) {
    return HWY_DYNAMIC_DISPATCH(part)(pose, a, node_a, b, node_b, steps, normal.data());
}

void separate_siblings(const PlanePose& pose,
                       const PlaneBody& a,
                       const PlaneBody& b,
                       std::span<const WidePair> pairs,
                       std::uint32_t steps,
                       const PlaneNormal& normal,
                       std::span<PlaneTrial> trials) {
    HWY_DYNAMIC_DISPATCH(part_siblings)
    (pose, a, b, pairs, steps, normal.data(), trials.data());
}

std::uint32_t
farthest_point(const float* columns, std::uint32_t count, const std::array<float, 3>& direction) {
    // This call precedes the kernel's first one, so that a setting of the target takes effect.
    static_cast<void>(simd_target());
    return HWY_DYNAMIC_DISPATCH(farthest)(columns, count, direction);
}

} // namespace cd

#endif
