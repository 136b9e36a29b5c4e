// Computes the signs of DoubleSigns, one pair per SIMD lane, with the bounds of double_signs.hpp.
// Compiled for every target.

// Highway's include guard: once per target.
#if defined(CD_DOUBLE_PAIRS_SIGNS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CD_DOUBLE_PAIRS_SIGNS_INL_HPP
#undef CD_DOUBLE_PAIRS_SIGNS_INL_HPP
#else
#define CD_DOUBLE_PAIRS_SIGNS_INL_HPP
#endif

#include "common/pair/stages/double_batch/double_pairs_frame-inl.hpp"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cd {
namespace HWY_NAMESPACE {
namespace double_pairs {

HWY_INLINE M any_of(M x, M y, M z) {
    return hn::Or(hn::Or(x, y), z);
}

HWY_INLINE M all_of(M x, M y, M z) {
    return hn::And(hn::And(x, y), z);
}

struct SizedVec {
    Sized x;
    Sized y;
    Sized z;
};

template <class C>
HWY_INLINE SizedVec between(const C (&from)[3], const C (&to)[3]) {
    return {between(from[0], to[0]), between(from[1], to[1]), between(from[2], to[2])};
}

/// Computes a d - b c.
HWY_INLINE Sized determinant(const Sized& a, const Sized& b, const Sized& c, const Sized& d) {
    return {hn::Sub(hn::Mul(a.value, d.value), hn::Mul(b.value, c.value)),
            hn::Add(hn::Mul(a.size, d.size), hn::Mul(b.size, c.size))};
}

/// Raises the size against underflow.
HWY_INLINE Sized raised(const Sized& s) {
    return {s.value, hn::Add(s.size, hn::Set(Doubles(), double_signs::size_raise))};
}

HWY_INLINE SizedVec cross(const SizedVec& l, const SizedVec& r) {
    return {raised(determinant(l.y, l.z, r.y, r.z)),
            raised(determinant(l.z, l.x, r.z, r.x)),
            raised(determinant(l.x, l.y, r.x, r.y))};
}

HWY_INLINE V dot(V lx, V ly, V lz, V rx, V ry, V rz) {
    return hn::Add(hn::Add(hn::Mul(lx, rx), hn::Mul(ly, ry)), hn::Mul(lz, rz));
}

HWY_INLINE Sized dot(const SizedVec& l, const SizedVec& r) {
    return {dot(l.x.value, l.y.value, l.z.value, r.x.value, r.y.value, r.z.value),
            dot(l.x.size, l.y.size, l.z.size, r.x.size, r.y.size, r.z.size)};
}

/// Lanes where the sign is proven positive, negative or 0.
struct Sign {
    M positive;
    M negative;
    M zero;

    HWY_INLINE Sign() {}
    HWY_INLINE Sign(M is_positive, M is_negative, M is_zero)
        : positive(is_positive), negative(is_negative), zero(is_zero) {}
};

HWY_INLINE M is_known(const Sign& s) {
    return any_of(s.positive, s.negative, s.zero);
}

/// Proves signs as DoubleSigns does.
class Prover {
  public:
    HWY_INLINE Prover(M is_tame, double bound_scale)
        : is_tame_(is_tame),
          volume_bound_(hn::Set(Doubles(), bound_scale * double_signs::volume_bound)),
          area_bound_(hn::Set(Doubles(), bound_scale * double_signs::area_bound)) {}

    /// `is_one` marks lanes in which coincident corners make the volume 0.
    HWY_INLINE Sign volume_sign(const Sized& volume, M is_one) const {
        const M is_least = hn::Lt(volume.size, hn::Set(Doubles(), double_signs::term_least));
        return sign(volume.value,
                    hn::Mul(volume_bound_, volume.size),
                    hn::Or(is_one, hn::And(is_tame_, is_least)));
    }
    HWY_INLINE Sign area_sign(const Sized& area, M is_one) const {
        const M is_nothing = hn::Eq(area.size, hn::Zero(Doubles()));
        return sign(area.value,
                    hn::Mul(area_bound_, area.size),
                    hn::Or(is_one, hn::And(is_tame_, is_nothing)));
    }

  private:
    static HWY_INLINE Sign sign(V value, V error, M is_zero) {
        const V bound = hn::Add(error, hn::Set(Doubles(), double_signs::underflow));
        const M positive = hn::Gt(value, bound);
        const M negative = hn::Lt(value, hn::Neg(bound));
        return {positive, negative, hn::AndNot(hn::Or(positive, negative), is_zero)};
    }

    M is_tame_;
    V volume_bound_;
    V area_bound_;
};

/// Proven signs of a triangle's corners against the other's plane.
struct Sides {
    M positive[3];
    M negative[3];
    M zero[3];

    HWY_INLINE Sides() {}

    HWY_INLINE void set(std::size_t corner, const Sign& sign) {
        positive[corner] = sign.positive;
        negative[corner] = sign.negative;
        zero[corner] = sign.zero;
    }
    HWY_INLINE M are_known() const {
        return all_of(is_known({positive[0], negative[0], zero[0]}),
                      is_known({positive[1], negative[1], zero[1]}),
                      is_known({positive[2], negative[2], zero[2]}));
    }
    HWY_INLINE M are_one_sided() const {
        return hn::Or(all_of(positive[0], positive[1], positive[2]),
                      all_of(negative[0], negative[1], negative[2]));
    }
    HWY_INLINE M are_flat() const { return all_of(zero[0], zero[1], zero[2]); }
    /// Tests whether corners are on both sides of the plane.
    HWY_INLINE M do_cross() const {
        return hn::And(any_of(positive[0], positive[1], positive[2]),
                       any_of(negative[0], negative[1], negative[2]));
    }
};

} // namespace double_pairs
} // namespace HWY_NAMESPACE
} // namespace cd
HWY_AFTER_NAMESPACE();

#endif
