// Exact reference for bodies that move between two keys, in integers. Shares no code with the
// engine.
#pragma once

#include "common/geometry/pose.hpp"
#include "tests/support/exact_world.hpp"

#include <cstdint>

namespace cd::tests {

/// The length root(square) / denominator, in units of 2^-128.
struct ExactLength {
    Integer square;
    Integer denominator = 1;
};

/// Whether the lengths differ by at most `difference`, which is at least 2^-70.
[[nodiscard]] bool differ_by_at_most(const ExactLength& l, const ExactLength& r, double difference);

/// A moving body by the definition: turned by q(tau) = (1 - tau) q0 + tau q1, divided by its
/// length, at (1 - tau) c0 + tau c1.
class OraclePath {
  public:
    /// The keys are of kind Quaternion. Components of quaternions are multiples of 2^-64,
    /// coordinates of 2^-128.
    OraclePath(const Pose& from, const Pose& to);

    /// A point in the world: `point` / `denominator`, in units of 2^-128.
    struct Place {
        ExactPoint point;
        Integer denominator;
    };
    /// Returns where a point of the body is at tau = index / 2^level.
    [[nodiscard]] Place place(const Vec3& point, std::uint64_t index, unsigned level) const;

  private:
    std::array<Integer, 4> q0_;
    std::array<Integer, 4> q1_;
    ExactPoint c0_;
    ExactPoint c1_;
};

[[nodiscard]] ExactLength distance(const OraclePath::Place& l, const OraclePath::Place& r);

} // namespace cd::tests
