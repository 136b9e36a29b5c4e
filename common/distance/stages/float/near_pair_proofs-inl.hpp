// Proposes points of two triangles and proves bounds of their distance, one pair per SIMD lane. The
// bounds are derived in near_pair_kernel.cpp. Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_NEAR_PAIR_PROOFS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_NEAR_PAIR_PROOFS_INL_HPP
#undef CD_NEAR_PAIR_PROOFS_INL_HPP
#else
#define CD_NEAR_PAIR_PROOFS_INL_HPP
#endif

#include "common/distance/stages/float/near_pair_kernel.hpp"
#include "common/pair/stages/float/float_pair_columns-inl.hpp"
#include "common/pair/stages/float/float_pair_rows-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {

using M = hn::Mask<Floats>;

HWY_INLINE Columns add(const Columns& l, const Columns& r) {
    return {hn::Add(l.x, r.x), hn::Add(l.y, r.y), hn::Add(l.z, r.z)};
}

HWY_INLINE Columns sub(const Columns& l, const Columns& r) {
    return {hn::Sub(l.x, r.x), hn::Sub(l.y, r.y), hn::Sub(l.z, r.z)};
}

HWY_INLINE Columns times(const Columns& v, V by) {
    return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)};
}

HWY_INLINE Columns chosen(M mask, const Columns& yes, const Columns& no) {
    return {hn::IfThenElse(mask, yes.x, no.x),
            hn::IfThenElse(mask, yes.y, no.y),
            hn::IfThenElse(mask, yes.z, no.z)};
}

/// Returns the vectors in lanes whose mask is set; 0 elsewhere.
HWY_INLINE Columns chosen(M mask, const Columns& yes) {
    return {hn::IfThenElseZero(mask, yes.x),
            hn::IfThenElseZero(mask, yes.y),
            hn::IfThenElseZero(mask, yes.z)};
}

/// Returns the quotient, limited to [0, 1]; 0 for NaN.
HWY_INLINE V share_of(V dividend, V divisor) {
    const Floats df;
    const V share = hn::Div(dividend, divisor);
    return hn::IfThenElseZero(hn::Gt(share, hn::Zero(df)), hn::Min(share, hn::Set(df, 1)));
}

/// Pairs in A's coordinates. All points of the difference A - B are d + A' - B', with A' in the
/// triangle of 0, p and q, and B' in that of 0, r and s.
struct NearPairs {
    Columns p;
    Columns q;
    Columns r;
    Columns s;
    Columns d;
    V pp;
    V qq;
    V rr;
    V ss;
    V error;  ///< The error e of both bounds.
    M usable; ///< Nothing is proven for pairs without this bit.
};

HWY_INLINE NearPairs load_pairs(const FloatPairPose& pose,
                                const NearPairErrors& errors,
                                const Rows& rows) {
    const Floats df;
    NearPairs pairs;
    pairs.p = load_columns(rows.p);
    pairs.q = load_columns(rows.q);
    pairs.r = turned(pose, load_columns(rows.e));
    pairs.s = turned(pose, load_columns(rows.f));
    pairs.d = load_columns(rows.d);
    pairs.pp = square(pairs.p);
    pairs.qq = square(pairs.q);
    pairs.rr = square(pairs.r);
    pairs.ss = square(pairs.s);
    const V dd = square(pairs.d);
    const V least = hn::Set(df, 0x1p-64F);
    const auto weighted = [&](float weight, V squared) {
        return hn::Mul(hn::Set(df, weight), hn::Sqrt(hn::Add(squared, least)));
    };
    const V of_a = weighted(errors.of_a, hn::Max(pairs.pp, pairs.qq));
    const V of_b = weighted(errors.of_b, hn::Max(pairs.rr, pairs.ss));
    const V of_d = hn::Add(weighted(errors.of_d, dd),
                           hn::Mul(hn::Set(df, errors.of_corner), hn::Load(df, rows.d_error)));
    pairs.error = hn::Add(hn::Add(of_a, of_b), of_d);
    const V sum = hn::Add(hn::Add(hn::Add(pairs.pp, pairs.qq), hn::Add(pairs.rr, pairs.ss)), dd);
    pairs.usable = hn::Lt(sum, hn::Set(df, 0x1p76F)); // False for NaN.
    return pairs;
}

/// A point z of the difference as the direction of a proof.
struct Look {
    V square;    ///< z.z
    V gap;       ///< The least z.x of the points x of the difference.
    Columns end; ///< A corner of the difference with that product.
};

/// Computes the products of z with the five vectors of a pair.
template <bool finds_end>
HWY_INLINE Look look_along(const NearPairs& pairs, const Columns& z) {
    const Floats df;
    const V zp = dot(z, pairs.p);
    const V zq = dot(z, pairs.q);
    const V zr = dot(z, pairs.r);
    const V zs = dot(z, pairs.s);
    const V zero = hn::Zero(df);
    const V least_a = hn::Min(hn::Min(zp, zq), zero);
    const V most_b = hn::Max(hn::Max(zr, zs), zero);
    Look look;
    look.square = square(z);
    look.gap = hn::Sub(hn::Add(dot(z, pairs.d), least_a), most_b);
    if constexpr (finds_end) {
        const Columns of_a =
            chosen(hn::Eq(zp, least_a), pairs.p, chosen(hn::Eq(zq, least_a), pairs.q));
        const Columns of_b =
            chosen(hn::Eq(zr, most_b), pairs.r, chosen(hn::Eq(zs, most_b), pairs.s));
        look.end = sub(add(pairs.d, of_a), of_b);
    }
    return look;
}

/// What is proven about the pairs of a vector.
struct Proofs {
    M far;
    M near;
};

/// Proves from a point of the difference what it can; see near_pair_kernel.cpp.
HWY_INLINE Proofs proofs_of(const NearPairs& pairs, const Look& look, const NearPairLimit& limit) {
    const Floats df;
    const V length = hn::Sqrt(look.square);
    const V beyond = hn::Mul(hn::Add(hn::Set(df, limit.raised), pairs.error), length);
    const M is_sound = hn::Ge(look.square, hn::Set(df, 0x1p-100F));
    const M far = hn::And(hn::Gt(look.gap, beyond), is_sound);
    const M near = hn::Le(hn::Add(length, pairs.error), hn::Set(df, limit.lowered));
    return {hn::And(far, pairs.usable), hn::And(near, pairs.usable)};
}

HWY_INLINE Columns middle(const NearPairs& pairs) {
    const V third = hn::Set(Floats(), 0x1.555554p-2F); // At most 1 / 3.
    return sub(add(pairs.d, times(add(pairs.p, pairs.q), third)),
               times(add(pairs.r, pairs.s), third));
}

/// Moves z to the point of least norm on the segment from z to a corner of the difference: a step
/// of Gilbert, An iterative procedure for computing the minimum of a quadratic form (1966).
HWY_INLINE Columns stepped(const Columns& z, const Columns& end) {
    const Columns along = sub(end, z);
    const V share = share_of(hn::Neg(dot(z, along)), square(along));
    return add(z, times(along, share));
}

/// Decides what three steps from the centroids decide.
HWY_INLINE Proofs decide_by_steps(const NearPairs& pairs, const NearPairLimit& limit) {
    Columns z = middle(pairs);
    Look look = look_along<true>(pairs, z);
    Proofs all = proofs_of(pairs, look, limit);
    for (int step = 0; step < 3; ++step) {
        z = stepped(z, look.end);
        look = look_along<true>(pairs, z);
        const Proofs more = proofs_of(pairs, look, limit);
        all = {hn::Or(all.far, more.far), hn::Or(all.near, more.near)};
    }
    return all;
}

/// Keeps the shortest vector.
class Shortest {
  public:
    HWY_INLINE explicit Shortest(const Columns& first) : best_(first), square_(square(first)) {}

    HWY_INLINE void keep(const Columns& z) {
        const V squared = square(z);
        const M is_less = hn::Lt(squared, square_);
        best_ = chosen(is_less, z, best_);
        square_ = hn::IfThenElse(is_less, squared, square_);
    }
    HWY_INLINE const Columns& best() const { return best_; }

  private:
    Columns best_;
    V square_;
};

/// An edge and its square.
struct EdgeColumns {
    Columns along;
    V square;
};

/// Tries the nearest points of an edge of A and one of B, as Ericson, Real-Time Collision Detection
/// (2004), section 5.1.9. `w` is the first corner of A's edge minus that of B's.
HWY_INLINE void
try_edges(const Columns& w, const EdgeColumns& u, const EdgeColumns& v, Shortest& shortest) {
    const V uv = dot(u.along, v.along);
    const V wu = dot(w, u.along);
    const V wv = dot(w, v.along);
    const V area = hn::Sub(hn::Mul(u.square, v.square), hn::Mul(uv, uv));
    const V first = share_of(hn::Sub(hn::Mul(uv, wv), hn::Mul(v.square, wu)), area);
    const V t = share_of(hn::Add(hn::Mul(first, uv), wv), v.square);
    const V s = share_of(hn::Sub(hn::Mul(t, uv), wu), u.square);
    shortest.keep(sub(add(w, times(u.along, s)), times(v.along, t)));
}

/// A face from its first corner: two edges and their products.
struct FaceColumns {
    Columns u;
    Columns v;
    V uu;
    V uv;
    V vv;
    V area;

    HWY_INLINE FaceColumns(const Columns& first, const Columns& second, V uu_, V vv_)
        : u(first), v(second), uu(uu_), uv(dot(first, second)), vv(vv_) {
        area = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
    }
};

/// Tries a corner and a point of a face: the corner's foot if that is inside, else some other
/// point. `w` is the corner minus the face's first corner.
HWY_INLINE void try_face(const Columns& w, const FaceColumns& face, Shortest& shortest) {
    const V wu = dot(w, face.u);
    const V wv = dot(w, face.v);
    const V of_u = share_of(hn::Sub(hn::Mul(face.vv, wu), hn::Mul(face.uv, wv)), face.area);
    const V raw_v = share_of(hn::Sub(hn::Mul(face.uu, wv), hn::Mul(face.uv, wu)), face.area);
    const V of_v = hn::Min(raw_v, hn::Sub(hn::Set(Floats(), 1), of_u));
    shortest.keep(sub(w, add(times(face.u, of_u), times(face.v, of_v))));
}

/// Returns the shortest vector of the difference that the features give: nine pairs of edges,
/// which include corners, and six of corner and face.
HWY_INLINE Columns shortest_of_features(const NearPairs& pairs) {
    const Columns& p = pairs.p;
    const Columns& q = pairs.q;
    const Columns& r = pairs.r;
    const Columns& s = pairs.s;
    const Columns& d = pairs.d;
    Shortest shortest(d);
    const Columns pq = sub(q, p);
    const Columns rs = sub(s, r);
    const EdgeColumns of_a[3] = {{p, pairs.pp}, {q, pairs.qq}, {pq, square(pq)}};
    const EdgeColumns of_b[3] = {{r, pairs.rr}, {s, pairs.ss}, {rs, square(rs)}};
    // The edges begin in the first corner but for the third ones.
    const Columns dp = add(d, p);
    const Columns dr = sub(d, r);
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            try_edges(d, of_a[i], of_b[j], shortest);
        }
        try_edges(dr, of_a[i], of_b[2], shortest);
        try_edges(dp, of_a[2], of_b[i], shortest);
    }
    try_edges(sub(dp, r), of_a[2], of_b[2], shortest);

    const FaceColumns face_b(r, s, pairs.rr, pairs.ss);
    try_face(d, face_b, shortest);
    try_face(dp, face_b, shortest);
    try_face(add(d, q), face_b, shortest);
    // A point of A's face minus a corner of B: the foot of A's first corner minus that corner, on
    // the reversed edges.
    const V zero = hn::Zero(Floats());
    const Columns none{zero, zero, zero};
    const FaceColumns face_a(sub(none, p), sub(none, q), pairs.pp, pairs.qq);
    try_face(d, face_a, shortest);
    try_face(dr, face_a, shortest);
    try_face(sub(d, s), face_a, shortest);
    return shortest.best();
}

} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
