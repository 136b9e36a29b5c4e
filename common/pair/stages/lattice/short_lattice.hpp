// Corners of bodies that are not rotated against each other, as integers of one or two words: the
// lattice of designed parts, found without taking their numbers apart.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"

#include <optional>

namespace cd {

/// Converts with one multiplication by a power of two, to the finest lattice on which the largest
/// number of a pair fits.
class ShortLattice {
  public:
    /// `poses` are plain: A is not rotated and B but for its axes' order and directions.
    explicit ShortLattice(const PosePair& poses);

    /// The corners in units of that lattice; false, and they mean nothing, if not all numbers lie
    /// on it.
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
    std::array<int, 3> source_{}; ///< The axis of B that becomes each of A's.
    Vec3 direction_;              ///< 1 or -1.
};

} // namespace cd
