// The double-double stage of distances. The stage proves an answer or gives none.
#pragma once

#include "common/distance/distance_certificate.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

#include <cstddef>
#include <optional>

namespace cd {

class DoubleDoubleDistance {
  public:
    /// Multiplies all error bounds by `error_scale`. Answers are right only from 1 on; tests use
    /// less to show that the error bounds are needed.
    explicit DoubleDoubleDistance(const PosePair& poses, double error_scale = 1);

    /// Proves bounds of the distance from a feature that is probably the nearest. `near_a` is any
    /// finite point, best one near A.
    [[nodiscard]] DistanceBounds<DoubleDouble>
    bounds(const Corners& a, const Corners& b, const Vec3& near_a, std::size_t feature) const;

  private:
    LocalMap a_;
    LocalMap b_;
    double scale_;
};

/// Tests whether a distance is at most `d`; nothing if the bounds do not prove it.
[[nodiscard]] std::optional<bool> is_within(const DistanceBounds<DoubleDouble>& bounds, double d);

/// Returns the double nearest to a distance; nothing if numbers within the bounds may round
/// differently.
[[nodiscard]] std::optional<double> rounded(const DistanceBounds<DoubleDouble>& bounds);

/// Returns a number that no distance within the proven bounds rounds to more than.
[[nodiscard]] double most_rounded(const DistanceBounds<DoubleDouble>& bounds);

} // namespace cd
