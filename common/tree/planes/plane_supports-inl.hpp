// Finds the points of a node that are farthest along a direction. Compiled for every target.

// Highway's include guard: it admits the file once for each target.
#if defined(CD_PLANE_SUPPORTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_PLANE_SUPPORTS_INL_HPP
#undef CD_PLANE_SUPPORTS_INL_HPP
#else
#define CD_PLANE_SUPPORTS_INL_HPP
#endif

#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/planes/support_view.hpp"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

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

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
