// Corners of bodies without relative rotation, as integers of one or two words: a fast lattice for
// designed parts that does not decompose their numbers.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"

#include <optional>

namespace cd {

/// Converts each number to lattice units by one multiplication by a power of two. The lattice is
/// the finest on which the pair's largest number fits the words.
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
    std::array<int, 3> source_{}; ///< For each world axis, the axis of B that the pose maps there.
    Vec3 direction_;              ///< For each world axis 1, or -1 if the pose mirrors B's axis.
};

} // namespace cd
