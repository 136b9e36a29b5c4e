// The double stage of distances: bounds with an error bound. The stage proves an answer or gives
// none.
#pragma once

#include "common/distance/distance_certificate.hpp"
#include "common/geometry/pose.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace cd {

/// The double stage's view of a pair.
struct DoublePair {
    Vec3 near_a;             ///< A finite point near A, relative to which the corners are.
    std::size_t feature = 0; ///< The feature that is probably the nearest.
    DistanceBounds<double> bounds;

    /// Tests whether the distance is at most `d`; nothing if that is unproven.
    [[nodiscard]] std::optional<bool> is_within(double d) const;
};

class DoubleDistance {
  public:
    /// Multiplies all error bounds by `error_scale`. Bounds are right only from 1 on; tests use
    /// less to show that the error bounds are needed.
    explicit DoubleDistance(const PosePair& poses, double error_scale = 1);

    /// Chooses a feature and proves bounds of the distance.
    [[nodiscard]] DoublePair look_at(const Corners& a, const Corners& b) const;
    /// Chooses a feature and proves nothing.
    [[nodiscard]] DoublePair choose(const Corners& a, const Corners& b) const;
    /// Returns the vector from a point of A to one of B that are probably the nearest, in the
    /// world.
    [[nodiscard]] Vec3 displacement(const Corners& a, const Corners& b) const;

  private:
    /// A body's pose in doubles.
    struct Map {
        Mat3 rotation;
        Vec3 translation;
        double entry_error = 0; ///< Bounds the error of each entry of `rotation`.
        double largest = 0;     ///< Bounds each |entry|.

        explicit Map(const Pose& pose);
        /// Poses three corners relative to a point; raises `error` to the bound of their errors,
        /// and `magnitude` to the sum of the magnitudes of a coordinate's terms.
        void place(const Corners& corners,
                   const Vec3& origin,
                   Vec3* to,
                   double& error,
                   double& magnitude) const;
    };
    struct Placed {
        std::array<Vec3, 6> corners;
        Vec3 origin;
        double error = 0;
        double magnitude = 0;
    };
    [[nodiscard]] Placed placed(const Corners& a, const Corners& b) const;

    Map a_;
    Map b_;
    double scale_;
};

} // namespace cd
