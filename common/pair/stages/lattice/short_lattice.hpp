// Corners of bodies without relative rotation, as integers of one or two words: a fast lattice for
// designed parts that does not decompose their numbers.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"

#include <optional>

namespace cd {

/// Converts with one multiplication by a power of two, to the finest lattice that holds the pair's
/// largest number.
class ShortLattice {
  public:
    /// `poses` must be plain: A is not rotated, and B only has its axes permuted and mirrored.
    explicit ShortLattice(const PosePair& poses);

    /// Converts the corners to lattice units. Returns false, with meaningless corners, if a number
    /// is not on the lattice.
    template <std::size_t n>
    [[nodiscard]] bool place(const Corners& a, const Corners& b, LatticeCorners<n>& placed) const;

    template <std::size_t n>
    [[nodiscard]] std::optional<LatticeCorners<n>> corners(const Corners& a,
                                                           const Corners& b) const {
        LatticeCorners<n> placed;
        return place(a, b, placed) ? std::optional(placed) : std::nullopt;
    }

  private:
    Vec3 translation_a_;
    Vec3 translation_b_;
    double largest_translation_ = 0;
    std::array<int, 3> source_{}; ///< B's axis for each axis of A.
    Vec3 direction_;              ///< Sign of each axis: 1 or -1.
};

} // namespace cd
