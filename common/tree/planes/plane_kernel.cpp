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

#include "common/geometry/highway_targets.hpp"
#include "common/tree/planes/support_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/planes/plane_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, 16>;
using Wide = hn::Vec<Lanes>;
using Doubles = hn::CappedTag<double, 8>;
using Rounded = hn::Rebind<float, Doubles>;

/// A point and how far it is along a direction.
struct Support {
    float reach;
    float point[3];
};

HWY_INLINE float dot(const float* x, const float* y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// The farthest point of each lane so far.
template <class D>
struct Farthest {
    hn::Vec<D> reach;
    hn::Vec<hn::RebindToSigned<D>> number; ///< Less its lane.
};

template <class D>
HWY_INLINE Farthest<D> none(D d) {
    return {hn::Set(d, -std::numeric_limits<float>::infinity()), hn::Zero(hn::RebindToSigned<D>())};
}

/// The index of a point and how far it is along a direction.
struct Found {
    std::uint32_t number;
    float reach;
};

template <class D>
HWY_INLINE hn::Vec<D> reach_of(D d, const hn::Vec<D>* point, const float* direction) {
    return hn::MulAdd(point[0],
                      hn::Set(d, direction[0]),
                      hn::MulAdd(point[1],
                                 hn::Set(d, direction[1]),
                                 hn::Mul(point[2], hn::Set(d, direction[2]))));
}

template <class D>
HWY_INLINE void add(D, hn::Vec<D> reach, std::uint32_t first, Farthest<D>& best) {
    const hn::RebindToSigned<D> di;
    const auto is_farther = hn::Gt(reach, best.reach);
    best.reach = hn::IfThenElse(is_farther, reach, best.reach);
    best.number = hn::IfThenElse(
        hn::RebindMask(di, is_farther), hn::Set(di, static_cast<std::int32_t>(first)), best.number);
}

/// Returns the farthest point of all lanes.
template <class D>
HWY_INLINE Found found_in(D d, const Farthest<D>& best) {
    const hn::RebindToSigned<D> di;
    const auto most = hn::MaxOfLanes(d, best.reach);
    const auto lane = hn::FindFirstTrue(d, hn::Eq(best.reach, most));
    alignas(64) std::int32_t numbers[hn::MaxLanes(di)];
    hn::Store(best.number, di, numbers);
    const auto number =
        lane < 0 ? 0 : static_cast<std::uint32_t>(numbers[lane]) + static_cast<std::uint32_t>(lane);
    return {number, hn::GetLane(most)};
}

HWY_INLINE Found farthest_of(const float* columns, std::uint32_t count, const float* direction) {
    const Lanes d;
    Farthest<Lanes> best = none(d);
    for (std::uint32_t i = 0; i < count; i += static_cast<std::uint32_t>(hn::Lanes(d))) {
        const Wide at[3] = {hn::LoadU(d, columns + i),
                            hn::LoadU(d, columns + count + i),
                            hn::LoadU(d, columns + 2 * std::size_t{count} + i)};
        add(d, reach_of(d, at, direction), i, best);
    }
    return found_in(d, best);
}

/// Reads coordinates that follow each other as x, y, z, less the centre.
HWY_INLINE void load(Lanes d, const float* from, const float* center, Wide* to) {
    hn::LoadInterleaved3(d, from, to[0], to[1], to[2]);
    for (std::size_t k = 0; k < 3; ++k) {
        to[k] = hn::Sub(to[k], hn::Set(d, center[k]));
    }
}

HWY_INLINE void load(Rounded d, const double* from, const float* center, hn::Vec<Rounded>* to) {
    const Doubles dd;
    hn::Vec<Doubles> at[3];
    hn::LoadInterleaved3(dd, from, at[0], at[1], at[2]);
    for (std::size_t k = 0; k < 3; ++k) {
        to[k] = hn::DemoteTo(d, hn::Sub(at[k], hn::Set(dd, static_cast<double>(center[k]))));
    }
}

/// Returns the farthest of `count` vertices, which follow each other as x, y, z. At least the lanes
/// of a vector can be read from each on.
template <class D, class Number>
HWY_INLINE Found farthest_vertex(
    D d, const Number* vertices, std::uint32_t count, const float* center, const float* direction) {
    Farthest<D> best = none(d);
    for (std::uint32_t i = 0; i < count; i += static_cast<std::uint32_t>(hn::Lanes(d))) {
        hn::Vec<D> at[3];
        load(d, vertices + 3 * std::size_t{i}, center, at);
        const auto reach = hn::IfThenElse(hn::FirstN(d, count - i),
                                          reach_of(d, at, direction),
                                          hn::Set(d, -std::numeric_limits<float>::infinity()));
        add(d, reach, i, best);
    }
    return found_in(d, best);
}

HWY_INLINE float relative(double coordinate, float center) {
    return static_cast<float>(coordinate - static_cast<double>(center));
}

/// Returns the farthest of a node's chosen points.
HWY_INLINE Support support_of_chosen(const PlaneBody& body,
                                     const SupportSet& set,
                                     const float* direction) {
    const std::uint32_t count = padded(set.count);
    const float* columns = body.columns + 3 * std::size_t{set.first};
    const Found found = farthest_of(columns, count, direction);
    return {found.reach,
            {columns[found.number],
             columns[count + found.number],
             columns[2 * std::size_t{count} + found.number]}};
}

template <class D, class Number>
HWY_INLINE Support support_in(
    D d, const Number* vertices, std::uint32_t count, const float* center, const float* direction) {
    const Found found = farthest_vertex(d, vertices, count, center, direction);
    const Number* at = vertices + 3 * std::size_t{found.number};
    Support support;
    support.reach = found.reach;
    for (std::size_t k = 0; k < 3; ++k) {
        support.point[k] = static_cast<float>(at[k] - static_cast<Number>(center[k]));
    }
    return support;
}

/// Returns the farthest of a node's vertices.
HWY_INLINE Support support_of_vertices(const PlaneBody& body,
                                       const SupportSet& set,
                                       const float* direction) {
    const std::size_t first = 3 * std::size_t{set.first};
    const float* center = body.center.data();
    return body.floats != nullptr
               ? support_in(Lanes(), body.floats + first, set.count, center, direction)
               : support_in(Rounded(), body.doubles + first, set.count, center, direction);
}

/// Bounds how far the children of a node are along a direction, from the node's boxes.
HWY_INLINE void
bound_children(const PlaneBody& body, const WideNode& node, const float* direction, float* bounds) {
    const Lanes d;
    const hn::Rebind<std::uint8_t, Lanes> bytes;
    const hn::Rebind<std::int32_t, Lanes> whole;
    float weights[3]; // Per step, along the node's axes.
    const std::uint8_t* ends[3];
    float start = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        weights[k] =
            node.steps[k] * (node.columns[0][k] * direction[0] + node.columns[1][k] * direction[1] +
                             node.columns[2][k] * direction[2]);
        ends[k] = weights[k] > 0 ? node.high[k].data() : node.low[k].data();
        start += relative(node.origin[k], body.center[k]) * direction[k];
    }
    for (std::size_t i = 0; i < wide_children_max; i += hn::Lanes(d)) {
        Wide sum = hn::Set(d, start);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto end = hn::PromoteTo(whole, hn::LoadU(bytes, ends[k] + i));
            sum = hn::MulAdd(hn::ConvertTo(d, end), hn::Set(d, weights[k]), sum);
        }
        hn::StoreU(sum, d, bounds + i);
    }
}

/// Returns the farthest vertex of a node, whose children have all their vertices as points. Skips
/// children whose boxes are nearer.
HWY_INLINE Support support_of_children(const PlaneBody& body,
                                       const WideNode& node,
                                       const float* direction) {
    float bounds[wide_children_max];
    bound_children(body, node, direction, bounds);
    Support best;
    best.reach = -std::numeric_limits<float>::infinity();
    for (;;) {
        std::uint32_t next = 0;
        for (std::uint32_t i = 1; i < node.count; ++i) {
            next = bounds[i] > bounds[next] ? i : next;
        }
        if (!(bounds[next] > best.reach)) {
            return best;
        }
        bounds[next] = -std::numeric_limits<float>::infinity();
        const Support found = support_of_vertices(body, body.sets[node.first + next], direction);
        if (found.reach > best.reach) {
            best = found;
        }
    }
}

/// Returns the support point of a node.
HWY_INLINE Support support_of(const PlaneBody& body, std::uint32_t node, const float* direction) {
    const SupportSet& set = body.sets[node];
    if (set.is_chosen) {
        return support_of_chosen(body, set, direction);
    }
    return body.nodes[node].is_leaf ? support_of_vertices(body, set, direction)
                                    : support_of_children(body, body.nodes[node], direction);
}

float part(const PlanePose& pose,
           const PlaneBody& a,
           std::uint32_t node_a,
           const PlaneBody& b,
           std::uint32_t node_b,
           std::uint32_t steps,
           float* n) {
    const float* r = pose.rotation.data();
    const float* s = pose.translation.data();
    // 1.002 covers (6), and the other factor the length of n and the roundings of this sum.
    const float needed =
        1.00001F * (a.sets[node_a].eps + 1.002F * b.sets[node_b].eps + pose.margin + pose.reach);
    for (std::uint32_t step = 1;; ++step) {
        const Support of_a = support_of(a, node_a, n);
        const float m[3] = {r[0] * n[0] + r[3] * n[1] + r[6] * n[2],
                            r[1] * n[0] + r[4] * n[1] + r[7] * n[2],
                            r[2] * n[0] + r[5] * n[1] + r[8] * n[2]};
        const float back[3] = {-m[0], -m[1], -m[2]};
        const Support of_b = support_of(b, node_b, back);
        const float gap = (dot(n, s) - of_b.reach) - of_a.reach;
        if (gap > needed) {
            return gap - needed;
        }
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
            return 0; // The support points coincide, or numbers overflow.
        }
        for (std::size_t i = 0; i < 3; ++i) {
            n[i] = next[i] / length;
        }
        if (step >= steps) {
            return 0;
        }
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

std::uint32_t
farthest_point(const float* columns, std::uint32_t count, const std::array<float, 3>& direction) {
    // This call precedes the kernel's first one, so that a setting of the target takes effect.
    static_cast<void>(simd_target());
    return HWY_DYNAMIC_DISPATCH(farthest)(columns, count, direction);
}

} // namespace cd

#endif
