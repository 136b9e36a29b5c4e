// Finds the corners of the set of points that two triangles share, from exact signs alone.
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

/// A corner of the set of points that two triangles share. The triangles' corners are numbered as
/// for CornerSigns: 0 to 2 are A's, 3 to 5 B's. An edge has the number of its starting corner.
struct SharedCorner {
    enum class Kind : std::uint8_t {
        Corner,   ///< The corner `first`.
        Piercing, ///< Where edge `first` properly passes through the other triangle's plane.
        Crossing, ///< Where A's edge `first` crosses B's edge `second` in the common plane.
    };
    Kind kind = Kind::Corner;
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

/// All shared corners of a pair, distinct, in arbitrary order. A corner that both triangles have is
/// listed as A's.
struct SharedCorners {
    std::array<SharedCorner, 6> corner;
    std::size_t count = 0;
};

/// Finds shared corners in integers of a fixed number of words. Not thread-safe.
class SharedCornerFinder {
  public:
    explicit SharedCornerFinder(const PosePair& poses);

    /// Returns nothing for degenerate triangles, or if the numbers exceed the words. `of_a` and
    /// `of_b` are sides of A's and B's corners against the other plane; known ones count as proven.
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
