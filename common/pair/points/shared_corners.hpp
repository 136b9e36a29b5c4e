// Finds which corners the shared set of two triangles has, from exact signs alone.
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

/// A corner of the shared set. Triangle corners are numbered as for CornerSigns: 0 to 2 are A's, 3
/// to 5 B's; an edge is named by its starting corner.
struct SharedCorner {
    enum class Kind : std::uint8_t {
        Corner,   ///< The corner `first`.
        Piercing, ///< The edge `first` properly passes through the other triangle's plane.
        Crossing, ///< In the common plane, A's edge `first` crosses B's edge `second`.
    };
    Kind kind = Kind::Corner;
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

/// Distinct corners in arbitrary order. A corner of both triangles is listed as A's.
struct SharedCorners {
    std::array<SharedCorner, 6> corner;
    std::size_t count = 0;
};

/// Finds shared corners in integers of a fixed number of words. Not thread-safe.
class SharedCornerFinder {
  public:
    explicit SharedCornerFinder(const PosePair& poses);

    /// Returns nothing for degenerate triangles, or if the numbers' range exceeds the words. Known
    /// sides of a triangle's corners against the other's plane are taken as proven.
    [[nodiscard]] std::optional<SharedCorners> find(const Corners& a,
                                                    const Corners& b,
                                                    const PlaneSides& of_a = unknown_sides,
                                                    const PlaneSides& of_b = unknown_sides);

  private:
    PosePair poses_;
    std::optional<ShortLattice> short_lattice_;  ///< Set if there is no relative rotation.
    std::unique_ptr<const PoseLattice> lattice_; ///< Made on first use.
};

} // namespace cd
