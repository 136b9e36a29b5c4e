// Proves signs of a pair in doubles. Header-only, so that it is inlined where a pair is decided.
//
// Bounds, with u = 2^-53. A computed vector x has sizes X with |x_k| <= X_k and errors of at most
// 2.01 u X_k. A difference of two doubles is rounded once, so X_k = |x_k| suffices (and X_k = 0
// means that the true component is 0). An error of up to e before the last rounding adds e / 2u to
// X_k.
//
// A determinant of x, y, z is a sum of six products x_i y_j z_k; its permanent P is the same sum of
// X_i Y_j Z_k. Errors of the input change it by at most ((1 + 2.01 u)^3 - 1) P <= 6.1 u P, where
// the true components are bounded by (1 + 2.01 u) X_k too. Arithmetic: each term is rounded once in
// its cross product's products, once in the difference, once in the product with the third vector
// and twice in the sum of three: 5.1 u P. The computed permanent may be 6 u of itself too small. So
// 12 u P bounds the error. For determinants of two rows 8 u P does: 4.1 u from the input and two
// roundings.
//
// Underflow: a product loses at most 2^-1075. In a cross product's component that is 2^-1074, which
// is then multiplied with a component of z. Products and sums lose little more, and the permanent
// no more than that: 2^-1070 (1 + Z_1 + Z_2 + Z_3) in all. The sizes of a cross product are raised
// by q = 2^-950, which puts 12 u q (Z_1 + Z_2 + Z_3) into the bound; 2^-1000 covers the rest.
// Overflow makes infinities or NaN. No comparison with these proves anything: an infinite value has
// an infinite permanent.
//
// Zeros: a determinant is 0 if each term has a true factor 0, that is, a size 0. If no size is
// between 0 and 2^-300, any other term makes the permanent at least 2^-900, while q adds less than
// that where Z_k are below 2^40. Pairs for which this is uncertain are not tame, and none of their
// zeros is proven this way. On designed parts, whose faces follow the axes, this proves most ties.
// In most other ties, corners coincide.
//
// Signs, and whether they are proven, are practically random. Branches on them would cost more than
// all the arithmetic, so there are none.
#pragma once

#include "common/pair/numbers/two_doubles.hpp"
#include "common/pair/pair_decision.hpp"
#include "common/pair/poses/rounded_poses.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

namespace double_signs {

inline constexpr double u = 0x1p-53; // Unit roundoff.
inline constexpr double underflow = 0x1p-1000;
inline constexpr double volume_bound = 12 * u;
inline constexpr double area_bound = 8 * u;
inline constexpr double term_least = 0x1p-900;
/// Added to the sizes of a cross product against underflow.
inline constexpr double size_raise = 0x1p-950;
/// Factor from an error before the last rounding to the size that it adds.
inline constexpr double size_of_error = 1.01 / (2 * u);

/// A component of a vector in lane 0 and its size in lane 1; the same operations compute both.
struct Sized {
    TwoDoubles both;

    [[nodiscard]] double value() const { return both[0]; }
    [[nodiscard]] double size() const { return both[1]; }
};
using SizedVec = std::array<Sized, 3>;

/// Pairs a number, given in both lanes, with its magnitude.
inline Sized with_magnitude(TwoDoubles twice) {
    constexpr TwoMasks all_but_last_sign{-1, INT64_MAX};
    return {TwoDoubles(TwoMasks(twice) & all_but_last_sign)};
}

/// Computes a d - b c; the size is the sum of both products' sizes.
inline Sized determinant(const Sized& a, const Sized& b, const Sized& c, const Sized& d) {
    constexpr TwoMasks first_sign{INT64_MIN, 0};
    return {a.both * d.both + TwoDoubles(TwoMasks(b.both * c.both) ^ first_sign)};
}

/// Computes the cross product; raises its sizes against underflow.
inline SizedVec cross(const SizedVec& l, const SizedVec& r) {
    constexpr TwoDoubles q{0, size_raise};
    return {Sized{determinant(l[1], l[2], r[1], r[2]).both + q},
            Sized{determinant(l[2], l[0], r[2], r[0]).both + q},
            Sized{determinant(l[0], l[1], r[0], r[1]).both + q}};
}

inline Sized dot(const SizedVec& l, const SizedVec& r) {
    return {l[0].both * r[0].both + l[1].both * r[1].both + l[2].both * r[2].both};
}

inline int sign_of(double value, double bound, bool is_zero) {
    const int sign = static_cast<int>(value > bound) - static_cast<int>(value < -bound);
    return sign + unknown_sign * static_cast<int>((sign == 0) & !is_zero);
}

/// A set of pairs of corners: bit 3 i + j is for corner i of A and corner j of B, each 0 to 2.
using CornerPairs = std::uint32_t;

inline constexpr CornerPairs all_with_a = 7; ///< Pairs of A's corner 0; for corner i, << 3 i.
inline constexpr CornerPairs all_with_b = 0b1001001; ///< Pairs of B's corner 0; for corner j, << j.

/// Returns the bit of corners i and j, numbered 0 to 5 as in CornerSigns; 0 if both are of one
/// triangle.
inline CornerPairs pair_of(std::size_t i, std::size_t j) {
    const std::size_t a = i < j ? i : j;
    const std::size_t b = i < j ? j : i;
    return static_cast<CornerPairs>((a < 3) & (b >= 3)) << ((3 * a + b - 3) & 15);
}

} // namespace double_signs

/// Corners whose world coordinates are exactly doubles: of unmoved bodies, or of moved ones whose
/// sums do not round.
class ExactCorners {
  public:
    /// Requires that there is no relative rotation. Unless `are_exact`, the other methods must not
    /// be called.
    ExactCorners(const RoundedPoses& poses, const Corners& a, const Corners& b);

    [[nodiscard]] bool are_exact() const { return are_exact_; }
    [[nodiscard]] bool are_tame() const { return are_tame_; }
    /// Returns the pairs of corners that provably coincide.
    [[nodiscard]] double_signs::CornerPairs ones() const;

    /// Returns x_to - x_from along an axis, for corners of one triangle.
    [[nodiscard]] double_signs::Sized
    within(std::size_t from, std::size_t to, std::size_t axis) const {
        return double_signs::with_magnitude(at_[to][axis] - at_[from][axis]);
    }
    /// Returns x_to - x_from along an axis, for corners of different triangles.
    [[nodiscard]] double_signs::Sized
    across(std::size_t from, std::size_t to, std::size_t axis) const {
        return within(from, to, axis);
    }

  private:
    std::array<std::array<TwoDoubles, 3>, 6> at_; ///< Both lanes hold the same number.
    bool are_exact_ = true;
    bool are_tame_;
};

/// Corners under any poses. Along an axis that both poses keep, as rotations about the axis do,
/// coordinates are exactly high + low, each a double. The high parts are stored, and E_i = |low_i -
/// low_0| bounds corner i's share of the error of a difference within a triangle. Along other axes
/// corners are stored relative to their triangle's first; for differences between the triangles,
/// B's are relative to A's first.
///
/// An error E is stored in lane 1, as its contribution to a size; lane 0 is 0.
class PosedCorners {
  public:
    PosedCorners(const RoundedPoses& poses, const Corners& a, const Corners& b);

    [[nodiscard]] bool are_tame() const { return are_tame_; }
    [[nodiscard]] double_signs::CornerPairs ones() const { return ones_; }

    [[nodiscard]] double_signs::Sized
    within(std::size_t from, std::size_t to, std::size_t axis) const {
        return between(within_[from][axis], within_[to][axis]);
    }
    [[nodiscard]] double_signs::Sized
    across(std::size_t from, std::size_t to, std::size_t axis) const {
        return between(across_[from][axis], across_[to][axis]);
    }

  private:
    struct Component {
        TwoDoubles at;
        TwoDoubles error;
    };

    static double_signs::Sized between(const Component& from, const Component& to) {
        return {double_signs::with_magnitude(to.at - from.at).both + (to.error + from.error)};
    }

    void place_exact(const RoundedPoses& poses,
                     std::size_t axis,
                     const std::array<const Corners*, 2>& corners);
    void rotate(const RoundedPoses& poses, const Corners& a, const Corners& b);
    void find_ones(const RoundedPoses& poses, const std::array<const Corners*, 2>& corners);

    // By corner and axis: `within_` for differences within a triangle, `across_` between the two.
    std::array<std::array<Component, 3>, 6> within_;
    std::array<std::array<Component, 3>, 6> across_;
    double_signs::CornerPairs ones_ = 0;
    bool are_tame_;
};

/// Models CornerSigns; returns `unknown_sign` where doubles prove no sign.
template <class Frame>
class DoubleSigns {
  public:
    /// Multiplies all error bounds by `bound_scale`.
    explicit DoubleSigns(const Frame& frame, double bound_scale = 1)
        : frame_(frame), scale_(bound_scale), ones_(frame.ones()) {}

    [[nodiscard]] PlaneSides sides_of_a() const {
        using double_signs::all_with_a;
        return sides(3, 0, {all_with_a, all_with_a << 3, all_with_a << 6});
    }
    [[nodiscard]] PlaneSides sides_of_b() const {
        using double_signs::all_with_b;
        return sides(0, 3, {all_with_b, all_with_b << 1, all_with_b << 2});
    }

    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const {
        using namespace double_signs;
        // det(i' - i, j - i, j' - i) = det(i' - i, j - i, j' - j).
        const SizedVec normal = cross(within(i, i_to), across(i, j));
        const CornerPairs pairs =
            pair_of(i, j) | pair_of(i, j_to) | pair_of(i_to, j) | pair_of(i_to, j_to);
        return volume_sign(dot(normal, within(j, j_to)), pairs);
    }

    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
        const auto [x, y] = axes_after(axis);
        const bool is_within = (i < 3) == (k < 3);
        return turn_sign(
            double_signs::determinant(frame_.within(i, j, x),
                                      frame_.within(i, j, y),
                                      is_within ? frame_.within(i, k, x) : frame_.across(i, k, x),
                                      is_within ? frame_.within(i, k, y) : frame_.across(i, k, y)),
            ones_ & (double_signs::pair_of(i, k) | double_signs::pair_of(j, k)));
    }

    /// Returns the turns from i over j to each corner of the other triangle.
    [[nodiscard, gnu::always_inline]] PlaneSides
    turns(std::size_t i, std::size_t j, std::size_t axis) const {
        using namespace double_signs;
        const auto [x, y] = axes_after(axis);
        const std::size_t others = i < 3 ? 3 : 0;
        // Selects pairs where one of the edge's corners coincides with one of the others.
        const CornerPairs ones = i < 3 ? (ones_ >> (3 * i)) | (ones_ >> (3 * j))
                                       : (ones_ >> (i - 3)) | (ones_ >> (j - 3));
        const std::size_t step = i < 3 ? 1 : 3;
        const Sized along_x = frame_.within(i, j, x);
        const Sized along_y = frame_.within(i, j, y);
        PlaneSides turns{};
        for (std::size_t k = 0; k < 3; ++k) {
            turns[k] = turn_sign(determinant(along_x,
                                             along_y,
                                             frame_.across(i, others + k, x),
                                             frame_.across(i, others + k, y)),
                                 ones >> (step * k) & 1);
        }
        return turns;
    }

    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const {
        using namespace double_signs;
        const Sized apart =
            (i < 3) == (j < 3) ? frame_.within(j, i, axis) : frame_.across(j, i, axis);
        return sign_of(apart.value(), scale_ * 2.01 * u * apart.size(), apart.size() == 0);
    }

  private:
    static std::array<std::size_t, 2> axes_after(std::size_t axis) {
        return {axis == 2 ? 0 : axis + 1, axis == 0 ? 2 : axis - 1};
    }

    [[nodiscard]] double_signs::SizedVec within(std::size_t from, std::size_t to) const {
        return {frame_.within(from, to, 0), frame_.within(from, to, 1), frame_.within(from, to, 2)};
    }
    [[nodiscard]] double_signs::SizedVec across(std::size_t from, std::size_t to) const {
        return {frame_.across(from, to, 0), frame_.across(from, to, 1), frame_.across(from, to, 2)};
    }

    /// Proves the sign of an area, which is 0 if `ones`, pairs of coincident corners, is not empty.
    [[nodiscard]] int turn_sign(const double_signs::Sized& area,
                                double_signs::CornerPairs ones) const {
        using namespace double_signs;
        const bool is_zero = (frame_.are_tame() & (area.size() == 0)) | (ones != 0);
        return sign_of(area.value(), scale_ * area_bound * area.size() + underflow, is_zero);
    }

    /// Proves the sign of a volume x . z, where x is a cross product. The volume is 0 if a pair of
    /// corners in `pairs` coincides.
    [[nodiscard]] int volume_sign(const double_signs::Sized& volume,
                                  double_signs::CornerPairs pairs) const {
        using namespace double_signs;
        const bool is_zero =
            (frame_.are_tame() & (volume.size() < term_least)) | ((ones_ & pairs) != 0);
        return sign_of(volume.value(), scale_ * volume_bound * volume.size() + underflow, is_zero);
    }

    [[nodiscard]] PlaneSides sides(std::size_t plane,
                                   std::size_t corners,
                                   const std::array<double_signs::CornerPairs, 3>& pairs) const {
        using namespace double_signs;
        const SizedVec normal = cross(within(plane, plane + 1), within(plane, plane + 2));
        PlaneSides sides{};
        for (std::size_t i = 0; i < 3; ++i) {
            sides[i] = volume_sign(dot(normal, across(plane, corners + i)), pairs[i]);
        }
        return sides;
    }

    const Frame& frame_;
    double scale_;
    double_signs::CornerPairs ones_;
};

} // namespace cd
