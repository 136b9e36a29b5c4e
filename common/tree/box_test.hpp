// Whether two oriented boxes may overlap: never a wrong "no".
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>

namespace cd {

/// A box of B as seen by A, rounded.
struct PosedBox {
    std::array<double, 9> axes{};   ///< Row-major: B's three directions in A's body coordinates.
    std::array<double, 3> center{}; ///< In A's body coordinates.
    std::array<double, 3> half{};
    double error = 0; ///< What its rounding and the pose's errors can add to any projection.
};

/// The separating axes of two boxes under one relative pose.
class BoxTest {
  public:
    /// `error_scale` multiplies every error bound. Only from 1 on is an answer a proof: less is for
    /// tests, which show that the bounds are needed.
    explicit BoxTest(const RelativePose& b_to_a, double error_scale = 1);

    [[nodiscard]] PosedBox pose(const ObbNode& b) const;

    /// A box in A's body coordinates around a triangle of B, in exact terms. All of space, or NaN
    /// on an axis, where numbers overflow or the pose's bounds are of no use.
    [[nodiscard]] Aabb bounds(const Corners& b) const;

    /// False only if no point of box `a` is a point of box `b`, in exact terms, under the true
    /// poses. True wherever numbers overflow or the pose's bounds are of no use.
    [[nodiscard]] bool may_overlap(const ObbNode& a, const PosedBox& b) const;
    [[nodiscard]] bool may_overlap(const ObbNode& a, const ObbNode& b) const {
        return may_overlap(a, pose(b));
    }

    /// Bounds the distance of any point of box `a` from any of box `b`, in A's body coordinates, in
    /// exact terms. Infinite, never NaN, where numbers overflow or the pose's bounds are of no use.
    [[nodiscard]] double distance_max(const ObbNode& a, const PosedBox& b) const;

  private:
    std::array<double, 9> rotation_{};
    std::array<double, 3> translation_{};
    double translation_size_ = 0; ///< The sum of its components' sizes.
    double rotation_error_ = 0;
    double translation_error_ = 0;
    double frame_error_ = 0; ///< Per half size of B: see the source.
    double rounding_;        ///< The unit roundoff, or less: what the bounds say of roundings.
};

} // namespace cd
