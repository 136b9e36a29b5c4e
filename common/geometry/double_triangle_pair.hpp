// The first stage of the decision: doubles with error bounds. It proves an answer or gives none.
#pragma once

#include "common/geometry/triangle_pair.hpp"

#include <optional>

namespace cd {

/// A pose's linear part in doubles, with what its use costs in exactness.
struct RoundedRotation {
    Mat3 matrix;
    double entry_error = 0;   ///< Bounds the error of each entry.
    double entry_largest = 0; ///< Bounds each entry, rounded or true.
    bool is_identity = false; ///< Then using it rounds nothing.

    explicit RoundedRotation(const Pose& pose);
};

class DoubleTrianglePair {
  public:
    explicit DoubleTrianglePair(const PosePair& poses);

    /// What is proven of the pair under the exact poses; nothing where rounding leaves it open.
    /// Never allocates.
    [[nodiscard]] std::optional<PairClass> classify(const Corners& a, const Corners& b) const;

  private:
    RoundedRotation a_;
    RoundedRotation b_;
    Vec3 offset_; ///< ta - tb, rounded once.
};

} // namespace cd
