// Proves by a few products that a plane still parts two nodes when the pose has changed.
#pragma once

#include "common/tree/planes/plane_kernel.hpp"

#include <array>
#include <cstdint>

namespace cd {

/// What a plane's proof under one pose says about other poses.
class PlaneProof {
  public:
    PlaneProof() = default;
    /// `separate` has parted B's node from a node of A under `pose` along `normal`, with `slack` to
    /// spare.
    PlaneProof(const PlanePose& pose,
               const PlaneBody& b,
               std::uint32_t node_b,
               const PlaneNormal& normal,
               float slack);

    /// Returns whether a plane with the same normal proves that the same nodes are apart under
    /// another pose of the same bodies. A false answer proves nothing.
    [[nodiscard]] bool holds(const PlanePose& pose, const PlaneNormal& normal) const;

  private:
    PlaneNormal turned_{};          ///< The normal in B's coordinates.
    std::array<float, 3> center_{}; ///< Of the box of B's node, relative to B's centre.
    float radius_ = 0;              ///< Bounds the distance of the node's points from `center_`.
    float needed_ = 0; ///< The node's least distance along the normal, less slack and reach.
};

} // namespace cd
