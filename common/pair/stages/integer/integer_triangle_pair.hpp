// The integer stages of the decision: exact, with as few words as the coordinates need.
#pragma once

#include "common/pair/pair_decision.hpp"
#include "common/pair/stages/integer/integer_signs.hpp"
#include "common/pair/stages/lattice/pair_lattice.hpp"
#include "common/pair/stages/lattice/short_lattice.hpp"
#include "common/pair/triangle_pair.hpp"

#include <memory>
#include <optional>
#include <variant>

namespace cd {

/// The corners of one pair as integers, set by IntegerTrianglePair::place. Models CornerSigns.
class IntegerCorners {
  public:
    [[nodiscard]] PlaneSides sides_of_a() const { return sides(unknown_sides, 3, 0); }
    [[nodiscard]] PlaneSides sides_of_b() const { return sides(unknown_sides, 0, 3); }
    /// Returns `IntegerSigns::sides` of the corners.
    [[nodiscard]] PlaneSides sides(PlaneSides known, std::size_t plane, std::size_t corners) const;
    [[nodiscard]] int
    edge_side(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to) const;
    [[nodiscard]] int turn(std::size_t i, std::size_t j, std::size_t k, std::size_t axis) const;
    [[nodiscard]] int difference(std::size_t i, std::size_t j, std::size_t axis) const;

  private:
    friend class IntegerTrianglePair;

    std::variant<std::monostate,
                 LatticeCorners<1>,
                 LatticeCorners<2>,
                 LatticeCorners<3>,
                 LatticeCorners<4>,
                 LatticeCorners<5>,
                 LatticeCorners<6>,
                 LatticeCorners<8>,
                 LatticeCorners<16>>
        corners_;
};

/// Decides pairs under one pair of poses in integers of up to sixteen words. Not thread-safe.
class IntegerTrianglePair {
  public:
    /// The poses must be plain (see `plain_poses`). Stage Lattice is skipped if `first` is a later
    /// stage.
    explicit IntegerTrianglePair(const PosePair& poses, PairStage first = PairStage::Lattice);

    /// Returns the stage that decides: Lattice for bodies without relative rotation, unless that
    /// stage is skipped; else WideInteger.
    [[nodiscard]] PairStage stage() const {
        return short_lattice_ ? PairStage::Lattice : PairStage::WideInteger;
    }

    /// Decides a pair without relative rotation if one word holds each coordinate, else returns
    /// nothing. This is the cheapest test, tried before all other stages. Never allocates.
    [[nodiscard]] std::optional<PairClass> classify_short(const Corners& a, const Corners& b) const;

    /// Fills `placed` with a pair's corners; returns false if their range exceeds sixteen words.
    /// Allocates at most at its first call.
    [[nodiscard]] bool place(const Corners& a, const Corners& b, IntegerCorners& placed);

  private:
    PosePair poses_;
    std::optional<ShortLattice> short_lattice_;
    std::unique_ptr<const PoseLattice> lattice_; ///< Made on first use.
};

} // namespace cd
