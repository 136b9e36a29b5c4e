// Decides pairs by the stages after floats. The first stage that can prove a sign does so.
#pragma once

#include "common/pair/stages/arbitrary/exact_triangle_pair.hpp"
#include "common/pair/stages/double/double_triangle_pair.hpp"
#include "common/pair/stages/double_double/double_double_signs.hpp"
#include "common/pair/stages/integer/integer_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"

#include <memory>
#include <optional>

namespace cd {

/// Decides pairs under one pair of poses. The decision procedure runs once per pair; the later
/// stages prove only the signs that doubles leave open. Each of them prepares the poses when a pair
/// first needs it. Not thread-safe.
class PairCascade {
  public:
    /// `poses` must outlive this object. Stages before `first` are skipped.
    PairCascade(const PosePair& poses, PairStage first);

    struct Decision {
        PairClass kind;
        PairStage stage; ///< The highest stage that was needed.
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
    std::optional<bool> passes_over_double_double_; ///< Empty until a pair needs the stage.
    std::optional<DoubleDoublePoses> in_double_double_;
    std::unique_ptr<const ExactTrianglePair> exact_;
};

} // namespace cd
