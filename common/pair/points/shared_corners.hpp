// Which corners the set of points has that two triangles share: from exact signs alone.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/lattice/pair_lattice.hpp"
#include "common/pair/stages/lattice/short_lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace cd {

/// What such a corner is. The triangles' own are numbered as for CornerSigns: 0 to 2 are A's, 3 to
/// 5 B's; an edge is named by the corner that it comes from.
struct SharedCorner {
    enum class Kind : std::uint8_t {
        Corner,   ///< The corner `first`.
        Piercing, ///< Where the edge `first` properly passes through the other triangle's plane.
        Crossing, ///< Where, in the one plane of both, A's edge `first` crosses B's edge `second`.
    };
    Kind kind = Kind::Corner;
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

/// Distinct points, in no order that matters. A corner of both triangles is A's.
struct SharedCorners {
    std::array<SharedCorner, 6> corner;
    std::size_t count = 0;
};

/// Finds them in integers of a fixed number of words. Not for use by two threads at once.
class SharedCornerFinder {
  public:
    explicit SharedCornerFinder(const PosePair& poses);

    /// Nothing for degenerate triangles, and where the numbers are further apart than the words
    /// reach. Sides of a triangle's corners against the other's plane that are known are taken as
    /// proven.
    [[nodiscard]] std::optional<SharedCorners> find(const Corners& a,
                                                    const Corners& b,
                                                    const PlaneSides& of_a = unknown_sides,
                                                    const PlaneSides& of_b = unknown_sides);

  private:
    PosePair poses_;
    std::optional<ShortLattice> short_lattice_;  ///< Of bodies not rotated against each other.
    std::unique_ptr<const PoseLattice> lattice_; ///< Made when it is first needed.
};

} // namespace cd
