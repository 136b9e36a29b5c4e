// The last stage: distances in integers, right on every finite input.
#pragma once

#include "common/distance/nearest_points.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/numbers/dyadic.hpp"

namespace cd {

/// Answers what TriangleDistance answers, from all features of a pair. Takes some 10 microseconds.
class ExactDistance {
  public:
    explicit ExactDistance(const PosePair& poses);

    [[nodiscard]] bool is_within(const Corners& a, const Corners& b, double d) const;
    [[nodiscard]] double rounded(const Corners& a, const Corners& b) const;
    [[nodiscard]] NearestPoints nearest(const Corners& a, const Corners& b) const;

  private:
    /// Returns a point near the triangle, in doubles; coordinates relative to it are short.
    [[nodiscard]] Vec3 nearby(const Corners& a) const;

    PosePair poses_;
    ExactPose a_;
    ExactPose b_;
    Dyadic norm_; ///< Product of both poses' norms, by which coordinates are scaled.
};

/// Returns the double nearest to sqrt(n / d) 2^exponent, rounded as by `nearest_double`; n must not
/// be negative, and d must be positive.
[[nodiscard]] double nearest_root(const ExactInt& n, const ExactInt& d, int exponent);

} // namespace cd
