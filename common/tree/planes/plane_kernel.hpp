// Proves that the contents of two nodes are apart, by a plane between their support points.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/tree/wide/pair_buckets.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace cd {

/// B's pose in A's coordinates, both relative to the centres of `SupportView`, with the margin that
/// rounding requires; plane_kernel.cpp derives it.
struct PlanePose {
    std::array<float, 9> rotation{}; ///< Row-major.
    std::array<float, 3> translation{};
    float margin = 0; ///< A length; infinite if nothing can be proven.
    float reach = 0;  ///< Nodes that are at most this far apart do not count as apart.
};

/// Returns the pose for trees with support points. `error_scale` multiplies the margin: a smaller
/// scale than 1 lets tests show that the margin is needed. `reach` is a length in A's coordinates.
[[nodiscard]] PlanePose plane_pose(const RelativePose& b_to_a,
                                   const SupportView& a,
                                   const SupportView& b,
                                   double error_scale = 1,
                                   double reach = 0);

/// A body as `separate` reads it.
struct PlaneBody {
    explicit PlaneBody(const WideView& tree);

    const WideNode* nodes;
    const SupportSet* sets;
    const float* columns;
    const float* floats; ///< See TriangleBlocks for the layout of the vertices.
    const double* doubles;
    std::array<float, 3> center;
    std::uint64_t id; ///< `SupportView::id`.
};

/// A unit vector from A to B in A's coordinates.
using PlaneNormal = std::array<float, 3>;

/// Returns a normal from A's centre to B's, or any unit vector if they coincide.
[[nodiscard]] PlaneNormal first_normal(const PlanePose& pose);

/// Tries to find a plane between two nodes, first with `normal`, then with at most `steps` - 1
/// improved ones (Chung and Wang, Quick collision detection of polytopes in virtual environments,
/// VRST 1996). If a plane proves that no point of A's node is within the pose's reach of B's,
/// returns by how much its gap exceeds what the proof needs, else 0. `normal` becomes the last one
/// that was tried or would be tried next. Both nodes have points.
[[nodiscard]] float separate(const PlanePose& pose,
                             const PlaneBody& a,
                             std::uint32_t node_a,
                             const PlaneBody& b,
                             std::uint32_t node_b,
                             std::uint32_t steps,
                             PlaneNormal& normal);

/// What came of looking for a plane between two nodes.
struct PlaneTrial {
    PlaneNormal normal{}; ///< The last one that was tried or would be tried next.
    float slack = 0;      ///< By how much the gap along the first one exceeds what a proof needs.
    bool is_apart = false;
};

/// Does what `separate` does for pairs of nodes of which one visit of a pair found all: first tries
/// `normal` on all pairs, for which it looks for each node's farthest point once, then improved
/// ones on each pair that is left, but not on pairs of leaves. Sets a trial for each pair. Not
/// empty.
void separate_siblings(const PlanePose& pose,
                       const PlaneBody& a,
                       const PlaneBody& b,
                       std::span<const WidePair> pairs,
                       std::uint32_t steps,
                       const PlaneNormal& normal,
                       std::span<PlaneTrial> trials);

/// Returns the index of the point that is farthest along a direction. `columns` has `count` first
/// coordinates, then as many second and third ones; `count` is a multiple of `support_padding`.
[[nodiscard]] std::uint32_t
farthest_point(const float* columns, std::uint32_t count, const std::array<float, 3>& direction);

} // namespace cd
