// Overlap test of two oriented boxes (SAT), conservative: it never gives a wrong "no".
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>

namespace cd {

/// A box of B in A's body coordinates, rounded.
struct PosedBox {
    std::array<double, 9> axes{};   ///< Row-major: B's three directions in A's body coordinates.
    std::array<double, 3> center{}; ///< In A's body coordinates.
    std::array<double, 3> half{};
    double error = 0; ///< Bound on what rounding and the pose's errors add to any projection.
};

/// The separating axis test (SAT) of two boxes under one relative pose.
class BoxTest {
  public:
    /// `error_scale` multiplies every error bound. Answers are proofs only if the scale is at least
    /// 1; tests use less to show that the bounds are needed. Boxes that are at most `reach` apart,
    /// in A's coordinates, count as overlapping.
    explicit BoxTest(const RelativePose& b_to_a, double error_scale = 1, double reach = 0);

    /// Changes the reach. Boxes that were posed before keep the reach they had.
    void set_reach(double reach) { reach_ = 1.01 * reach; }

    [[nodiscard]] PosedBox pose(const ObbNode& b) const;

    /// Returns a box in A's body coordinates that encloses all points within `reach` of a triangle
    /// of B, in exact terms. The box is all of space, or NaN on an axis, if numbers overflow or the
    /// pose is too far from rigid.
    [[nodiscard]] Aabb bounds(const Corners& b) const;

    /// Returns false only if boxes `a` and `b` have no point in common and are farther apart than
    /// `reach`, in exact terms, under the true poses. Returns true if numbers overflow or the pose
    /// is too far from rigid.
    [[nodiscard]] bool may_overlap(const ObbNode& a, const PosedBox& b) const;
    [[nodiscard]] bool may_overlap(const ObbNode& a, const ObbNode& b) const {
        return may_overlap(a, pose(b));
    }

    /// Returns a lower bound on the distance of two boxes in A's coordinates, or rather on how much
    /// it exceeds the reach. 0 if no axis of a box parts them, if numbers overflow, or if the pose
    /// is too far from rigid.
    [[nodiscard]] double least_distance(const ObbNode& a, const PosedBox& b) const;

  private:
    [[nodiscard]] double margin_of(const ObbNode& a, const PosedBox& b) const;

    std::array<double, 9> rotation_{};
    std::array<double, 3> translation_{};
    double translation_size_ = 0; ///< Sum of the absolute values of the translation's components.
    double rotation_error_ = 0;
    double translation_error_ = 0;
    double reach_ = 0;       ///< What the reach adds to any projection.
    double frame_error_ = 0; ///< Error per unit of B's half sizes, derived in box_test.cpp.
    double rounding_;        ///< Bound on each rounding: the unit roundoff times `error_scale`.
};

} // namespace cd
