// Corners of bodies that are not rotated against each other, as integers of one or two words: the
// lattice of designed parts, found without taking their numbers apart.
#pragma once

#include "common/geometry/integer_signs.hpp"
#include "common/geometry/pose.hpp"

#include <optional>

namespace cd {

/// Converts with one multiplication by a power of two, on a lattice that is tried, and replaced
/// where a pair does not lie on it: neighbours in a mesh mostly share one. What it converts is
/// exact, whatever was tried before.
class ShortLattice {
  public:
    /// `poses` are plain: A is not rotated and B but for its axes' order and directions.
    explicit ShortLattice(const PosePair& poses);

    /// The unit becomes 2^lowest, if that is in reach of doubles.
    void set_unit(int lowest);

    /// The corners in the present unit, if all are multiples of it and below 2^bits_max(n) units.
    template <std::size_t n>
    [[nodiscard]] std::optional<LatticeCorners<n>> corners(const Corners& a,
                                                           const Corners& b) const;

  private:
    Vec3 translation_a_;
    Vec3 translation_b_;
    std::array<std::size_t, 3> source_; ///< The axis of B that becomes each of A's.
    Vec3 direction_;                    ///< 1 or -1.
    double units_ = 1;                  ///< In 1.
};

} // namespace cd
