// Vectors of one pair per SIMD lane, read from the rows of float_pair_rows-inl.hpp. Compiled for
// every target.

// Highway's include guard: once per target.
#if defined(CD_FLOAT_PAIR_COLUMNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_FLOAT_PAIR_COLUMNS_INL_HPP
#undef CD_FLOAT_PAIR_COLUMNS_INL_HPP
#else
#define CD_FLOAT_PAIR_COLUMNS_INL_HPP
#endif

#include "common/pair/stages/float/float_pair_rows-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

/// The x, y and z components of a vector for each lane.
struct Columns {
    V x;
    V y;
    V z;
};

HWY_INLINE Columns cross(const Columns& a, const Columns& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
            hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

HWY_INLINE V dot(const Columns& a, const Columns& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Columns load_columns(const float* rows) {
    const Floats df;
    return {hn::Load(df, rows), hn::Load(df, rows + 1), hn::Load(df, rows + 2)};
}

#else

HWY_INLINE Columns load_columns(const float* rows) {
    const Floats df;
    const hn::Repartition<double, Floats> pairs;
    const V v0 = hn::Load(df, rows);
    const V v1 = hn::Load(df, rows + lanes);
    const V v2 = hn::Load(df, rows + 2 * lanes);
    const V v3 = hn::Load(df, rows + 3 * lanes);
    const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(df, v0, v1));
    const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(df, v2, v3));
    const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(df, v0, v1));
    const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(df, v2, v3));
    return {hn::BitCast(df, hn::InterleaveLower(pairs, xy01, xy23)),
            hn::BitCast(df, hn::InterleaveUpper(pairs, xy01, xy23)),
            hn::BitCast(df, hn::InterleaveLower(pairs, z01, z23))};
}

#endif

HWY_INLINE V row_times(const float* row, const Columns& v) {
    const Floats df;
    return hn::Add(hn::Add(hn::Mul(hn::Set(df, row[0]), v.x), hn::Mul(hn::Set(df, row[1]), v.y)),
                   hn::Mul(hn::Set(df, row[2]), v.z));
}

HWY_INLINE Columns turned(const FloatPairPose& pose, const Columns& v) {
    const float* rows = pose.rotation.data();
    return {row_times(rows, v), row_times(rows + 3, v), row_times(rows + 6, v)};
}

HWY_INLINE V square(const Columns& v) {
    return dot(v, v);
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
