// Why `holds` is right. The names are those of plane_kernel.cpp. Index 0 stands for the pose under
// which `separate` found the plane, index 1 for the pose that is asked about; m = R'n. Known is
//     min (m0 q) + n s0 - max (n p) - needed0 = slack > 0.
// Let c be the centre of the box of B's node, so that |q - c| <= radius for each of its points q:
//     m1 q = m0 q - (m0 - m1) q >= m0 q - (m0 - m1) c - |m0 - m1| radius.
// Therefore the gap under pose 1 still exceeds needed0 if
//     n s1 - (n s0 - slack) - (m0 - m1) c - |m0 - m1| radius > 0.
// needed0 holds the reach of pose 0 with the factor of `separate`; that of pose 1 takes its place.
// Rounding: needed0 holds the margin of pose 0, and its other terms do not depend on the pose. Pose
// 1 adds the error of m1, (12.7 u + 3.1 r) Q, and of s1, 1.8 abs + u |s|. The computation here adds
// 3.1 u |s| for n s under each pose; below 4 u (P + 2 Q + |s|) for the sums; and below 22 u Q for
// the rounding of c and for d = m0 - m1, d c and |d| radius, since |d| < 2.1. Twice the margins of
// both poses exceed the sum of these.
#include "common/tree/planes/plane_proof.hpp"

#include <cmath>
#include <cstddef>

namespace cd {

namespace {

constexpr float reach_factor = 1.00001F;

float dot(const float* x, const float* y) {
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// Returns a normal in B's coordinates, as `separate` does.
PlaneNormal turned_by(const PlanePose& pose, const PlaneNormal& n) {
    const auto& r = pose.rotation;
    return {r[0] * n[0] + r[3] * n[1] + r[6] * n[2],
            r[1] * n[0] + r[4] * n[1] + r[7] * n[2],
            r[2] * n[0] + r[5] * n[1] + r[8] * n[2]};
}

} // namespace

PlaneProof::PlaneProof(const PlanePose& pose,
                       const PlaneBody& b,
                       std::uint32_t node_b,
                       const PlaneNormal& normal,
                       float slack)
    : turned_(turned_by(pose, normal)),
      needed_(dot(normal.data(), pose.translation.data()) - slack + 2 * pose.margin -
              reach_factor * pose.reach) {
    const WideNode& box = b.nodes[node_b];
    float square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        center_[k] = static_cast<float>(box.origin[k] - static_cast<double>(b.center[k]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const float half = 127.5F * box.steps[k];
        square += half * half;
        for (std::size_t c = 0; c < 3; ++c) {
            center_[c] += half * box.columns[c][k];
        }
    }
    // The box's axes are orthonormal but for the rounding of floats.
    radius_ = 1.001F * std::sqrt(square);
}

bool PlaneProof::holds(const PlanePose& pose, const PlaneNormal& normal) const {
    const PlaneNormal turned = turned_by(pose, normal);
    const PlaneNormal change{
        turned_[0] - turned[0], turned_[1] - turned[1], turned_[2] - turned[2]};
    const float moved =
        dot(change.data(), center_.data()) + std::sqrt(dot(change.data(), change.data())) * radius_;
    return dot(normal.data(), pose.translation.data()) - needed_ - moved >
           2 * pose.margin + reach_factor * pose.reach;
}

} // namespace cd
