// Computes signs of a pair whose corners are integers on one lattice: exact and branch-free.
#pragma once

#include "common/pair/numbers/wide_int.hpp"
#include "common/pair/pair_decision.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// The six corners of a pair in units of one lattice, each |coordinate| below 2^bits_max(n).
template <std::size_t n>
using LatticeCorners = std::array<WideVec<n>, 6>;

/// Models CornerSigns. Sides that the constructor gets count as proven; only unknown ones are
/// computed.
template <std::size_t n>
class IntegerSigns {
  public:
    explicit IntegerSigns(const LatticeCorners<n>& corners,
                          const PlaneSides& of_a = unknown_sides,
                          const PlaneSides& of_b = unknown_sides)
        : corners_(corners), of_a_(of_a), of_b_(of_b) {}

    [[nodiscard]] PlaneSides sides_of_a() const { return sides(of_a_, 3, 0); }
    [[nodiscard]] PlaneSides sides_of_b() const { return sides(of_b_, 0, 3); }

    /// Returns the sides of the three corners from number `corners` on against the plane of the
    /// three from number `plane` on. Sides in `known` count as proven; the rest is computed.
    [[nodiscard]] PlaneSides sides(PlaneSides known, std::size_t plane, std::size_t corners) const {
        using namespace wide_int;
        if (!is_any_unknown(known)) {
            return known;
        }
        const WideVec<n>& origin = corners_[plane];
        const WideVec<2 * n> normal = cross(wide_int::difference(corners_[plane + 1], origin),
                                            wide_int::difference(corners_[plane + 2], origin));
        for (std::size_t i = 0; i < 3; ++i) {
            if (known[i] == unknown_sign) {
                known[i] = sign(dot(normal, wide_int::difference(corners_[corners + i], origin)));
            }
        }
        return known;
    }

    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const {
        using namespace wide_int;
        const WideVec<n> along_a = wide_int::difference(corners_[i_to], corners_[i]);
        const WideVec<n> across = wide_int::difference(corners_[j], corners_[i]);
        const WideVec<n> along_b = wide_int::difference(corners_[j_to], corners_[j]);
        // det(i' - i, j - i, j' - i) = det(i' - i, j - i, j' - j).
        return sign(dot(cross(along_a, across), along_b));
    }

    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const {
        using namespace wide_int;
        const std::size_t x = axis == 2 ? 0 : axis + 1;
        const std::size_t y = axis == 0 ? 2 : axis - 1;
        return sign(determinant(wide_int::difference(corners_[j][x], corners_[i][x]),
                                wide_int::difference(corners_[j][y], corners_[i][y]),
                                wide_int::difference(corners_[k][x], corners_[i][x]),
                                wide_int::difference(corners_[k][y], corners_[i][y])));
    }

    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const {
        for (std::size_t word = n; word-- > 0;) {
            const std::int64_t l = corners_[i][axis].word[word];
            const std::int64_t r = corners_[j][axis].word[word];
            if (l != r) {
                return l < r ? -1 : 1;
            }
        }
        return 0;
    }

  private:
    const LatticeCorners<n>& corners_;
    PlaneSides of_a_;
    PlaneSides of_b_;
};

} // namespace cd
