// The integer stages of the decision: exact, with as few words as the pair's coordinates need.
#pragma once

#include "common/geometry/pair_decision.hpp"
#include "common/geometry/pair_lattice.hpp"
#include "common/geometry/triangle_pair.hpp"

#include <memory>
#include <optional>

namespace cd {

class IntegerTrianglePair {
  public:
    explicit IntegerTrianglePair(const PosePair& poses) : poses_(poses) {}

    struct Decision {
        PairClass kind;
        PairStage stage; ///< Lattice for unrotated bodies and one word, else WideInteger.
    };
    /// Nothing where the numbers are further apart than sixteen words reach. Sides that are given
    /// are taken as proven. Allocates at its first call only.
    [[nodiscard]] std::optional<Decision> classify(const Corners& a,
                                                   const Corners& b,
                                                   const PlaneSides& of_a = unknown_sides,
                                                   const PlaneSides& of_b = unknown_sides);

  private:
    PosePair poses_;
    std::unique_ptr<const PoseLattice> lattice_; ///< Made when it is first needed.
};

} // namespace cd
