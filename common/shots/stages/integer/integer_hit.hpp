// The integer stage of hits: exact, with as few words as the coordinates need.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"
#include "common/pair/stages/lattice/pair_lattice.hpp"
#include "common/shots/line_hit.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <variant>

namespace cd {

/// The corners of a triangle and a segment as integers. Models HitSigns.
class IntegerHitSigns {
  public:
    [[nodiscard]] std::array<int, 2> sides() const;
    [[nodiscard]] int edge(std::size_t i) const;
    [[nodiscard]] int tie(std::size_t i, std::size_t axis) const;

  private:
    friend class IntegerHit;

    std::variant<LatticeCorners<2>, LatticeCorners<4>, LatticeCorners<6>, LatticeCorners<16>>
        corners_;
};

/// Places triangles of A and segments of B under one pair of poses.
class IntegerHit {
  public:
    explicit IntegerHit(const PosePair& poses) : lattice_(poses) {}

    /// Returns the signs; nothing if the range of the corners exceeds sixteen words.
    [[nodiscard]] std::optional<IntegerHitSigns> place(const Corners& a, const Segment& line) const;

  private:
    PoseLattice lattice_;
};

} // namespace cd
