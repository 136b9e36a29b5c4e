// The integer stages of the decision: exact, with as few words as the pair's coordinates need.
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

/// The corners of one pair as integers, and their signs. It has none until it is made by
/// IntegerTrianglePair::place. Models CornerSigns.
class IntegerCorners {
  public:
    [[nodiscard]] PlaneSides sides_of_a() const { return sides(unknown_sides, 3, 0); }
    [[nodiscard]] PlaneSides sides_of_b() const { return sides(unknown_sides, 0, 3); }
    /// See IntegerSigns.
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

/// Not for use by two threads at once.
class IntegerTrianglePair {
  public:
    /// From stage Lattice on, or from WideInteger. The poses are plain.
    explicit IntegerTrianglePair(const PosePair& poses, PairStage first = PairStage::Lattice);

    /// Lattice for bodies that are not rotated against each other, unless that is passed over; else
    /// WideInteger.
    [[nodiscard]] PairStage stage() const {
        return short_lattice_ ? PairStage::Lattice : PairStage::WideInteger;
    }

    /// The answer for bodies that are not rotated against each other, where one word is enough: the
    /// cheapest, before all other stages. Never allocates.
    [[nodiscard]] std::optional<PairClass> classify_short(const Corners& a, const Corners& b) const;

    /// Makes the corners of a pair; false where the numbers are further apart than sixteen words
    /// reach. Allocates at its first call at most.
    [[nodiscard]] bool place(const Corners& a, const Corners& b, IntegerCorners& placed);

    /// Nothing where they cannot be placed.
    [[nodiscard]] std::optional<PairClass> classify(const Corners& a, const Corners& b);

  private:
    PosePair poses_;
    std::optional<ShortLattice> short_lattice_;
    std::unique_ptr<const PoseLattice> lattice_; ///< Made when it is first needed.
};

} // namespace cd
