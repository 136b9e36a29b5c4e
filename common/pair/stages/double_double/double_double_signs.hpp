// The double-double stage of the decision, with error bounds some 2^50 times smaller than those of
// doubles. The stage proves a sign or gives none.
#pragma once

#include "common/pair/numbers/two_doubles.hpp"
#include "common/pair/pair_decision.hpp"
#include "common/pair/stages/double_double/double_double_rotation.hpp"

#include <array>
#include <cstddef>

namespace cd {

/// Two poses in double-double. The world's origin is moved so that B's translation is 0.
struct DoubleDoublePoses {
    /// An entry of both linear parts; `high` = head + tail, as in `exact_product`.
    struct Entry {
        BothBodies high;
        BothBodies low;
        BothBodies head;
        BothBodies tail;
    };
    std::array<std::array<Entry, 3>, 3> rows;
    std::array<BothBodies, 3> offset_high; ///< High part of ta - tb for A; 0 for B.
    std::array<BothBodies, 3> offset_low;  ///< Exactly the rest of ta - tb for A; 0 for B.
    double largest_a = 0;                  ///< Bounds A's |entries|.
    double largest_b = 0;                  ///< Bounds B's |entries|.
    double offset_largest = 0;             ///< The largest |high part| of ta - tb.

    explicit DoubleDoublePoses(const PosePair& poses);
};

/// Proves the signs of one pair in double-double. Returns `unknown_sign` for unproven ones.
class DoubleDoubleSigns {
  public:
    DoubleDoubleSigns(const DoubleDoublePoses& poses,
                      const Corners& a,
                      const Corners& b,
                      double bound_scale = 1);

    [[nodiscard]] PlaneSides sides_of_a() const { return sides(unknown_sides, 3, 0); }
    [[nodiscard]] PlaneSides sides_of_b() const { return sides(unknown_sides, 0, 3); }
    /// Returns the sides of the three corners from number `corners` on against the plane of the
    /// three from number `plane` on. Sides in `known` count as proven.
    [[nodiscard]] PlaneSides sides(PlaneSides known, std::size_t plane, std::size_t corners) const;
    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const;
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const;
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const;

  private:
    /// A difference of two corners. `error_` bounds each component's error, and `size` each
    /// |component|, computed or true.
    struct Sized {
        DoubleDoubleVec value;
        double size = 0;
    };

    void place(const DoubleDoublePoses& poses, const Corners& a, const Corners& b, std::size_t i);
    /// Computes x_to - x_from.
    [[nodiscard]] Sized between(std::size_t from, std::size_t to) const;
    [[nodiscard]] double volume_bound(const Sized& x, const Sized& y, const Sized& z) const;

    std::array<DoubleDoubleVec, 6> corners_; ///< World coordinates; low parts are not normalised.
    double error_ = 0; ///< Bounds the error of each component of a difference.
    double scale_ = 1;
};

} // namespace cd
