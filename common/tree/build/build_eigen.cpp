// Implements Eberly, A Robust Eigensolver for 3 x 3 Symmetric Matrices (2014), section "A
// Noniterative Algorithm", with Newton's steps in place of the cosine. Each SIMD lane holds one
// matrix. All choices are selections, so that no lane waits for another.
#include "common/tree/build/build_eigen.hpp"

#include "common/core/check.hpp"
#include "common/geometry/highway_targets.hpp"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "common/tree/build/build_eigen.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using V = hn::Vec<Doubles>;
using M = hn::Mask<Doubles>;

constexpr std::size_t lanes = hn::MaxLanes(Doubles());

struct Matrices {
    V xx;
    V xy;
    V xz;
    V yy;
    V yz;
    V zz;
};

struct Vectors {
    V x;
    V y;
    V z;
};

HWY_INLINE V all(double value) {
    return hn::Set(Doubles(), value);
}

HWY_INLINE V dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

HWY_INLINE Vectors cross(const Vectors& a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

HWY_INLINE Vectors scaled(V factor, const Vectors& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

/// Divides `a` by `length`. The result is exactly a unit vector if `a` has one nonzero component
/// and `length` is its absolute value.
HWY_INLINE Vectors quotient(const Vectors& a, V length) {
    return {a.x / length, a.y / length, a.z / length};
}

HWY_INLINE Vectors difference(const Vectors& a, const Vectors& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

HWY_INLINE Vectors sum(const Vectors& a, const Vectors& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

HWY_INLINE Vectors choose(M which, const Vectors& yes, const Vectors& no) {
    return {hn::IfThenElse(which, yes.x, no.x),
            hn::IfThenElse(which, yes.y, no.y),
            hn::IfThenElse(which, yes.z, no.z)};
}

HWY_INLINE Vectors times(const Matrices& m, const Vectors& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z,
            m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

HWY_INLINE Matrices scaled(V factor, const Matrices& m) {
    return {
        factor * m.xx, factor * m.xy, factor * m.xz, factor * m.yy, factor * m.yz, factor * m.zz};
}

/// Scales each matrix so that its largest entry has absolute value 1. Returns zero where an entry
/// is not finite.
HWY_INLINE Matrices normalised(const Matrices& m) {
    V largest = hn::Zero(Doubles());
    V none = largest; // Zero, or NaN where an entry is not finite.
    for (const V entry : {m.xx, m.xy, m.xz, m.yy, m.yz, m.zz}) {
        largest = hn::Max(largest, hn::Abs(entry));
        none = none + (entry - entry);
    }
    const M usable = hn::And(hn::Eq(none, none), hn::Gt(largest, hn::Zero(Doubles())));
    const auto part = [&](V entry) { return hn::IfThenElseZero(usable, entry / largest); };
    return {part(m.xx), part(m.xy), part(m.xz), part(m.yy), part(m.yz), part(m.zz)};
}

/// Returns the largest root b of b^3 - 3 b = 2 h for h in [0, 1], within 1e-10.
HWY_INLINE V largest_root(V h) {
    // The starting value is a quadratic polynomial in h that is exact at both ends and in its slope
    // at 0. It errs by less than 4e-3. Each Newton step squares the error, as the root is at least
    // sqrt(3) and so is far from the zero of the slope.
    V root = all(1.7320508075688772) + h * (all(1.0 / 3) - h * all(0.0653841409021101));
    for (int step = 0; step < 2; ++step) {
        const V square = root * root;
        root = root - (root * (square - all(3)) - (h + h)) / (all(3) * (square - all(1)));
    }
    return root;
}

/// Returns a unit vector v with m v = value v, for an eigenvalue that is far from the two others.
HWY_INLINE Vectors isolated_direction(const Matrices& m, V value) {
    // The rows of m - value span the plane perpendicular to v. The cross product of two of them may
    // be small, but not all three products.
    const Vectors x{m.xx - value, m.xy, m.xz};
    const Vectors y{m.xy, m.yy - value, m.yz};
    const Vectors z{m.xz, m.yz, m.zz - value};
    Vectors best = cross(x, y);
    V best_square = dot(best, best);
    for (const Vectors& other : {cross(x, z), cross(y, z)}) {
        const V square = dot(other, other);
        const M better = hn::Gt(square, best_square);
        best = choose(better, other, best);
        best_square = hn::Max(square, best_square);
    }
    return quotient(best, hn::Sqrt(best_square));
}

/// Returns a unit vector perpendicular to the unit vector `v`.
HWY_INLINE Vectors any_across(const Vectors& v) {
    const M by_x = hn::Gt(hn::Abs(v.x), hn::Abs(v.y));
    const V zero = hn::Zero(Doubles());
    const V larger = hn::IfThenElse(by_x, v.x, v.y);
    const Vectors across = choose(by_x, {zero - v.z, zero, v.x}, {zero, v.z, zero - v.y});
    return quotient(across, hn::Sqrt(larger * larger + v.z * v.z));
}

/// Turns u and v, orthonormal, into eigenvectors of m in their plane, the smaller eigenvalue first.
HWY_INLINE void turn_to_directions(const Matrices& m, Vectors& u, Vectors& v) {
    // One Jacobi rotation (Golub and Van Loan, Matrix Computations, 8.5).
    const Vectors mv = times(m, v);
    const V apart = dot(v, mv) - dot(u, times(m, u));
    const V uv = dot(u, mv);
    const V twice = uv + uv;
    const V zero = hn::Zero(Doubles());
    const V signed_twice = hn::IfThenElse(hn::Lt(apart, zero), zero - twice, twice);
    const V t = hn::IfThenZeroElse(hn::Eq(uv, zero),
                                   signed_twice /
                                       (hn::Abs(apart) + hn::Sqrt(apart * apart + twice * twice)));
    const V c = all(1) / hn::Sqrt(t * t + all(1));
    const V s = t * c;
    const Vectors first = difference(scaled(c, u), scaled(s, v));
    const Vectors second = sum(scaled(s, u), scaled(c, v));
    const M swapped = hn::Lt(apart + t * twice, zero);
    u = choose(swapped, second, first);
    v = choose(swapped, first, second);
}

HWY_INLINE void find_directions(const Matrices& any, Vectors* found) {
    // The matrix is mean + scale b, with b of trace 0 and its eigenvalues in [-2, 2].
    Matrices b = normalised(any);
    const V mean = (b.xx + b.yy + b.zz) / all(3);
    b.xx = b.xx - mean;
    b.yy = b.yy - mean;
    b.zz = b.zz - mean;
    const V off = b.xy * b.xy + b.xz * b.xz + b.yz * b.yz;
    const V square = (b.xx * b.xx + b.yy * b.yy + b.zz * b.zz + (off + off)) / all(6);
    const M round = hn::Le(square, all(0x1p-110));
    b = scaled(all(1) / hn::Sqrt(hn::IfThenElse(round, all(1), square)), b);
    const V determinant = b.xx * (b.yy * b.zz - b.yz * b.yz) - b.xy * (b.xy * b.zz - b.yz * b.xz) +
                          b.xz * (b.xy * b.yz - b.yy * b.xz);
    const V half = all(0.5) * determinant;
    // Either the largest or the smallest eigenvalue is at least 1.7 away from both others.
    const V zero = hn::Zero(Doubles());
    const M largest_first = hn::Ge(half, zero);
    const V root = largest_root(hn::Min(hn::Abs(half), all(1)));
    const Vectors isolated =
        isolated_direction(b, hn::IfThenElse(largest_first, root, zero - root));
    Vectors u = any_across(isolated);
    Vectors v = cross(isolated, u);
    turn_to_directions(b, u, v);
    found[0] = choose(round, {all(1), zero, zero}, choose(largest_first, u, isolated));
    found[1] = choose(round, {zero, all(1), zero}, choose(largest_first, v, u));
    found[2] = choose(round, {zero, zero, all(1)}, choose(largest_first, isolated, v));
}

void find_all_directions(const SymmetricMatrix* matrices,
                         Directions* directions,
                         std::size_t count) {
    const Doubles d;
    for (std::size_t begin = 0; begin < count; begin += lanes) {
        alignas(64) double entries[6][lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            // The last matrix fills the lanes that are left over.
            const SymmetricMatrix& m = matrices[std::min(begin + i, count - 1)];
            for (std::size_t k = 0; k < 6; ++k) {
                entries[k][i] = m[k];
            }
        }
        Vectors found[3];
        find_directions({hn::Load(d, entries[0]),
                         hn::Load(d, entries[1]),
                         hn::Load(d, entries[2]),
                         hn::Load(d, entries[3]),
                         hn::Load(d, entries[4]),
                         hn::Load(d, entries[5])},
                        found);
        alignas(64) double parts[9][lanes];
        for (std::size_t k = 0; k < 3; ++k) {
            hn::Store(found[k].x, d, parts[3 * k]);
            hn::Store(found[k].y, d, parts[3 * k + 1]);
            hn::Store(found[k].z, d, parts[3 * k + 2]);
        }
        for (std::size_t i = 0; i < lanes && begin + i < count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                directions[begin + i][k] =
                    Vec3(parts[3 * k][i], parts[3 * k + 1][i], parts[3 * k + 2][i]);
            }
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cd {

HWY_EXPORT(find_all_directions);

void principal_directions(std::span<const SymmetricMatrix> matrices,
                          std::span<Directions> directions) {
    CD_CHECK(matrices.size() == directions.size());
    HWY_DYNAMIC_DISPATCH(find_all_directions)
    (matrices.data(), directions.data(), matrices.size());
}

} // namespace cd

#endif
