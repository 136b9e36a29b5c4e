// The stages of the decision after floats: each sign of a pair is proven by the first that can.
#pragma once

#include "common/pair/stages/arbitrary/exact_triangle_pair.hpp"
#include "common/pair/stages/double/double_triangle_pair.hpp"
#include "common/pair/stages/double_double/double_double_triangle_pair.hpp"
#include "common/pair/stages/integer/integer_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"

#include <memory>
#include <optional>

namespace cd {

/// Decides under one pair of poses, sign by sign: a decision is made once, and only the signs that
/// doubles leave open cost more. What later stages need of the poses is made when it is first
/// needed. Not for use by two threads at once.
class PairCascade {
  public:
    /// `poses` outlive this. Stages before `first` are passed over.
    PairCascade(const PosePair& poses, PairStage first);

    struct Decision {
        PairClass kind;
        PairStage stage; ///< The highest that was needed.
    };
    [[nodiscard]] Decision classify(const Corners& a, const Corners& b);

  private:
    friend class LaterSigns;

    [[nodiscard]] const DoubleDoublePoses* in_double_double();
    [[nodiscard]] IntegerTrianglePair* in_integers();

    const PosePair& given_;
    PosePair plain_;
    PairStage first_;
    IntegerTrianglePair in_integers_;
    std::optional<DoubleTrianglePair> in_double_;
    std::optional<bool> passes_over_double_double_;
    std::optional<DoubleDoublePoses> in_double_double_;
    std::unique_ptr<const ExactTrianglePair> exact_;
};

} // namespace cd
