#include "common/shots/bundle/bundle_depth_kernel.hpp"

#include "common/geometry/highway_targets.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/shots/bundle/bundle_depth_kernel.cpp"
#include <hwy/foreach_target.h>
// Everything below is compiled for every target.
#include "common/pair/numbers/double_double_lanes-inl.hpp"
#include "common/shots/bundle/bundle_columns-inl.hpp"

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

/// Loads corner number `corner` of each triangle of a vector of triangles.
template <class T>
HWY_INLINE Corner load(const TriangleBlocks& a,
                       const T* coordinates,
                       std::size_t corner,
                       const std::uint32_t* slots) {
    // Loads four numbers for each vertex. The fourth, of the next vertex or a spare one, is unused.
    const bundle::Columns columns(Doubles(), [&](std::size_t i) {
        const std::size_t vertex =
            a.vertex_begin[slots[i] / block_size] + a.corners[slots[i]][corner];
        return coordinates + 3 * vertex;
    });
    Corner loaded;
    for (std::size_t k = 0; k < 3; ++k) {
        loaded.at[k] = columns.at[k];
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
};

/// The depths of triangles' planes, one triangle after the other: at the line at (y, z), the depth
/// is high_0 + low_0 + y (high_1 + low_1) + z (high_2 + low_2), within the margin. That is NaN
/// where there are no bounds.
struct Planes {
    alignas(64) bundle::Row first[DepthsOfMany::triangles_most];  ///< high_0, low_0, high_1, low_1
    alignas(64) bundle::Row second[DepthsOfMany::triangles_most]; ///< high_2, low_2, margin, margin

    HWY_INLINE Planes() {}
};

/// The planes of a vector of lines.
struct PlanesOfLines {
    Number terms[3];
    V margin;

    HWY_INLINE PlanesOfLines(const Planes& planes, const std::uint32_t* triangles) {
        const bundle::Columns first(Doubles(),
                                    [&](std::size_t i) { return planes.first[triangles[i]]; });
        const bundle::Columns second(Doubles(),
                                     [&](std::size_t i) { return planes.second[triangles[i]]; });
        terms[0] = {first.at[0], first.at[1]};
        terms[1] = {first.at[2], first.at[3]};
        terms[2] = {second.at[0], second.at[1]};
        margin = second.at[2];
    }
};

/// Finds the planes of one vector of triangles.
template <class T>
HWY_INLINE void find_planes_at(const BundleInA& bundle,
                               const Lines& lines,
                               double scale,
                               const TriangleBlocks& blocks,
                               const T* coordinates,
                               const std::uint32_t* slots,
                               std::size_t first,
                               Planes& planes) {
    const Doubles d;
    const Corner a = load(blocks, coordinates, 0, slots + first);
    const Vector u = edge(a, load(blocks, coordinates, 1, slots + first));
    const Vector v = edge(a, load(blocks, coordinates, 2, slots + first));
    const Vector normal = cross(u, v);
    const V zero = hn::Zero(d);
    const Vector corner(Number(a.at[0], zero), Number(a.at[1], zero), Number(a.at[2], zero));
    const Vector from = lines.start - corner;
    const Number apart = dot(normal, lines.minus_way);

    const V x = scaled(hn::Max(largest_of(u), largest_of(v)), 1.01);
    const V z = scaled(hn::Max(largest_of(lines.start), largest_of(corner)), 1.01);
    const V start_error =
        hn::Add(double_double_lanes::set(bundle.start_error), scaled(z, 2 * e * scale));
    const V w = hn::Add(scaled(largest_of(from), 1.01), scaled(start_error, 2));
    const V square = hn::Mul(x, x);
    const V across_error = double_double_lanes::set(300 * e * scale * bundle.across_size);
    const V side_error = hn::Mul(
        square, hn::Add(hn::Add(scaled(start_error, 8), scaled(w, 36 * e * scale)), across_error));
    const V apart_error = scaled(square, 7 * bundle.way_error + 24 * e * scale * bundle.way_size);
    const V error = hn::Add(side_error, apart_error);
    const V size = hn::Abs(apart.high);

    const Number per_side = Number(double_double_lanes::set(bundle.length), zero) / apart;
    const Number depths[3] = {dot(normal, from) * per_side,
                              dot(normal, lines.across[0]) * per_side,
                              dot(normal, lines.across[1]) * per_side};
    const V steepest = hn::Max(hn::Abs(depths[1].high), hn::Abs(depths[2].high));
    const V terms = hn::Add(hn::Abs(depths[0].high), scaled(steepest, bundle.across_size));
    const V margin = hn::Add(hn::Div(scaled(error, 1.21 * bundle.length), size),
                             scaled(terms, 10.1 * e * scale));
    const M is_known =
        hn::And(hn::And(is_in_range(x), is_in_range(z)), hn::Gt(size, scaled(error, 4)));
    const V bound = choose(is_known, margin, double_double_lanes::set(NAN));
    hn::StoreInterleaved4(
        depths[0].high, depths[0].low, depths[1].high, depths[1].low, d, planes.first[first]);
    hn::StoreInterleaved4(depths[2].high, depths[2].low, bound, bound, d, planes.second[first]);
}

/// Finds the depths of a vector of lines, NaN where the margin proves no rounding. Returns the
/// lanes whose depths are proven.
HWY_INLINE M find_depths_at(const Planes& planes,
                            const LineRows& rows,
                            std::size_t line,
                            DepthsOfMany& many) {
    const Doubles d;
    const PlanesOfLines of(planes, &many.triangles[line]);
    const V y = bundle::load_each(d, rows.across[0], &many.lines[line]);
    const V z = bundle::load_each(d, rows.across[1], &many.lines[line]);
    const Number depth = of.terms[0] + (of.terms[1] * y + of.terms[2] * z);
    const V least = hn::Add(depth.high, hn::Sub(depth.low, of.margin));
    const V most = hn::Add(depth.high, hn::Add(depth.low, of.margin));
    const M is_proven = hn::Eq(least, most);
    hn::Store(choose(is_proven, least, double_double_lanes::set(NAN)), d, &many.depths[line]);
    return is_proven;
}

template <class T>
HWY_INLINE bool find_depths(const BundleInA& bundle,
                            double scale,
                            const TriangleBlocks& blocks,
                            const T* coordinates,
                            const LineRows& rows,
                            DepthsOfMany& many) {
    const Doubles d;
    const Lines lines(bundle);
    Planes planes;
    for (std::size_t first = 0; first < many.count; first += hn::Lanes(d)) {
        find_planes_at(bundle, lines, scale, blocks, coordinates, many.slots.data(), first, planes);
    }
    M are_proven = always();
    const std::size_t end = many.begins[many.count];
    for (std::size_t line = 0; line < end; line += hn::Lanes(d)) {
        are_proven = hn::And(are_proven, find_depths_at(planes, rows, line, many));
    }
    return hn::AllTrue(d, are_proven);
}

} // namespace bundle_depths

bool find_depths_of_floats(const BundleInA* bundle,
                           double scale,
                           const TriangleBlocks* blocks,
                           const LineRows* rows,
                           DepthsOfMany* many) {
    return bundle_depths::find_depths(*bundle, scale, *blocks, blocks->floats.data(), *rows, *many);
}

bool find_depths_of_doubles(const BundleInA* bundle,
                            double scale,
                            const TriangleBlocks* blocks,
                            const LineRows* rows,
                            DepthsOfMany* many) {
    return bundle_depths::find_depths(
        *bundle, scale, *blocks, blocks->doubles.data(), *rows, *many);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(find_depths_of_floats);
HWY_EXPORT(find_depths_of_doubles);

bool find_depths(const BundleInA& bundle,
                 double bound_scale,
                 const TriangleBlocks& blocks,
                 const LineRows& rows,
                 DepthsOfMany& of_many) {
    return blocks.doubles.empty() ? HWY_DYNAMIC_DISPATCH(find_depths_of_floats)(
                                        &bundle, bound_scale, &blocks, &rows, &of_many)
                                  : HWY_DYNAMIC_DISPATCH(find_depths_of_doubles)(
                                        &bundle, bound_scale, &blocks, &rows, &of_many);
}

} // namespace cd

#endif
