// The integer stages of the decision: exact, with as few words as the pair's coordinates need.
#pragma once

#include "common/geometry/pair_decision.hpp"
#include "common/geometry/pair_lattice.hpp"
#include "common/geometry/short_lattice.hpp"
#include "common/geometry/triangle_pair.hpp"

#include <memory>
#include <optional>

namespace cd {

/// Not for use by two threads at once.
class IntegerTrianglePair {
  public:
    /// From stage Lattice on, or from WideInteger.
    explicit IntegerTrianglePair(const PosePair& poses, PairStage first = PairStage::Lattice);

    /// Lattice for bodies that are not rotated against each other, unless that is passed over; else
    /// WideInteger.
    [[nodiscard]] PairStage stage() const {
        return short_lattice_ ? PairStage::Lattice : PairStage::WideInteger;
    }

    /// The answer for bodies that are not rotated against each other, where one word is enough: the
    /// cheapest, before all other stages. Never allocates.
    [[nodiscard]] std::optional<PairClass> classify_short(const Corners& a, const Corners& b) const;

    /// Nothing where the numbers are further apart than sixteen words reach. Sides that are given
    /// are taken as proven. Allocates at its first call at most.
    [[nodiscard]] std::optional<PairClass> classify(const Corners& a,
                                                    const Corners& b,
                                                    const PlaneSides& of_a = unknown_sides,
                                                    const PlaneSides& of_b = unknown_sides);

  private:
    PosePair poses_;
    std::optional<ShortLattice> short_lattice_;
    std::unique_ptr<const PoseLattice> lattice_; ///< Made when it is first needed.
};

} // namespace cd
