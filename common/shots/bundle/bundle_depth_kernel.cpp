#include "common/shots/bundle/bundle_depth_kernel.hpp"

#include "common/geometry/highway_targets.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_depth_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/pair/numbers/double_double_lanes-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace bundle_depths {

using namespace double_double_lanes;

constexpr double e = double_double_error;

HWY_INLINE Number set(const DoubleDouble& number) {
    return {double_double_lanes::set(number.high), double_double_lanes::set(number.low)};
}

HWY_INLINE Vector set(const BundleInA::Vector& vector) {
    return {set(vector[0]), set(vector[1]), set(vector[2])};
}

HWY_INLINE V largest_of(const Vector& v) {
    return hn::Max(hn::Max(hn::Abs(v.at[0].high), hn::Abs(v.at[1].high)), hn::Abs(v.at[2].high));
}

HWY_INLINE V scaled(V value, double by) {
    return hn::Mul(value, double_double_lanes::set(by));
}

HWY_INLINE M is_in_range(V length) {
    return hn::And(hn::Ge(length, double_double_lanes::set(local_length_least)),
                   hn::Le(length, double_double_lanes::set(local_length_most)));
}

/// A corner of each lane's triangle.
struct Corner {
    V at[3];

    HWY_INLINE Corner() {}
};

HWY_INLINE Corner load(const DepthsOfMany& many, std::size_t corner, std::size_t first) {
    Corner loaded;
    for (std::size_t k = 0; k < 3; ++k) {
        loaded.at[k] = hn::Load(Doubles(), many.corners[corner][k].data() + first);
    }
    return loaded;
}

HWY_INLINE Vector edge(const Corner& from, const Corner& to) {
    return {exact_sum(to.at[0], hn::Neg(from.at[0])),
            exact_sum(to.at[1], hn::Neg(from.at[1])),
            exact_sum(to.at[2], hn::Neg(from.at[2]))};
}

/// The lines of a bundle, the same in all lanes.
struct Lines {
    Vector start;
    Vector across[2];
    Vector minus_way;

    HWY_INLINE explicit Lines(const BundleInA& bundle)
        : start(set(bundle.start)),
          across{set(bundle.across[0]), set(bundle.across[1])},
          minus_way(set(bundle.minus_way)) {}

    HWY_INLINE Vector start_of(V y, V z) const {
        Vector place;
        for (std::size_t k = 0; k < 3; ++k) {
            place.at[k] = start.at[k] + across[0].at[k] * y + across[1].at[k] * z;
        }
        return place;
    }
};

/// Returns the depths of one vector of hits, NaN where the bounds prove no rounding.
HWY_INLINE V depths_at(const BundleInA& bundle,
                       const Lines& lines,
                       double scale,
                       const DepthsOfMany& many,
                       std::size_t first) {
    const Doubles d;
    const Corner a = load(many, 0, first);
    const Vector u = edge(a, load(many, 1, first));
    const Vector v = edge(a, load(many, 2, first));
    const Vector normal = cross(u, v);
    const Vector start =
        lines.start_of(hn::Load(d, &many.across[0][first]), hn::Load(d, &many.across[1][first]));
    const V zero = hn::Zero(d);
    const Vector corner(Number(a.at[0], zero), Number(a.at[1], zero), Number(a.at[2], zero));
    const Vector from = start - corner;
    const Number side = dot(normal, from);
    const Number apart = dot(normal, lines.minus_way);

    const V x = scaled(hn::Max(largest_of(u), largest_of(v)), 1.01);
    const V z = scaled(hn::Max(largest_of(start), largest_of(corner)), 1.01);
    const V start_error =
        hn::Add(double_double_lanes::set(bundle.start_error), scaled(z, 2 * e * scale));
    const V w = hn::Add(scaled(largest_of(from), 1.01), scaled(start_error, 2));
    const V square = hn::Mul(x, x);
    const V side_error =
        hn::Mul(square, hn::Add(scaled(start_error, 8), scaled(w, 36 * e * scale)));
    const V apart_error = scaled(square, 7 * bundle.way_error + 24 * e * scale * bundle.way_size);
    const V error = hn::Add(side_error, apart_error);
    const V size = hn::Abs(apart.high);

    const Number depth = side / apart * double_double_lanes::set(bundle.length);
    const V share_error =
        hn::Add(hn::Div(scaled(error, 1.2), size), double_double_lanes::set(8 * e * scale));
    const V margin = hn::Add(scaled(share_error, 1.01 * bundle.length),
                             scaled(hn::Abs(depth.high), scale * 0x1p-104));
    const V least = hn::Add(depth.high, hn::Sub(depth.low, margin));
    const V most = hn::Add(depth.high, hn::Add(depth.low, margin));
    const M is_known = hn::And(hn::And(is_in_range(x), is_in_range(z)),
                               hn::And(hn::Gt(size, scaled(error, 4)), hn::Eq(least, most)));
    return choose(is_known, least, double_double_lanes::set(NAN));
}

void find_depths_on(const BundleInA* bundle, double scale, std::size_t count, DepthsOfMany* many) {
    const Doubles d;
    const Lines lines(*bundle);
    for (std::size_t first = 0; first < count; first += hn::Lanes(d)) {
        hn::Store(depths_at(*bundle, lines, scale, *many, first), d, &many->depths[first]);
    }
}

} // namespace bundle_depths

void find_depths_on(const BundleInA* bundle, double scale, std::size_t count, DepthsOfMany* many) {
    bundle_depths::find_depths_on(bundle, scale, count, many);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(find_depths_on);

void find_depths(const BundleInA& bundle,
                 double bound_scale,
                 std::size_t count,
                 DepthsOfMany& of_many) {
    HWY_DYNAMIC_DISPATCH(find_depths_on)(&bundle, bound_scale, count, &of_many);
}

} // namespace cd

#endif
