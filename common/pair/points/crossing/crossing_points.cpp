#include "common/pair/points/crossing/crossing_points.hpp"

#include "common/core/check.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/pair/stages/double_double/double_double_local.hpp"

namespace cd {

namespace {

CrossingPose plain_values(const LocalMap& map) {
    CrossingPose pose;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t j = 0; j < 3; ++j) {
            pose.high[k][j] = map.rows[k][j].high;
            pose.low[k][j] = map.rows[k][j].low;
        }
        pose.translation[k] = map.translation[static_cast<Eigen::Index>(k)];
        if (const auto& plain = map.plain[k]) {
            pose.rows[k] = {true, static_cast<std::size_t>(plain->column), plain->entry};
        }
    }
    pose.largest = map.largest;
    return pose;
}

} // namespace

CrossingPoints::CrossingPoints(const PosePair& poses, double bound_scale)
    : a_(plain_values(LocalMap(poses.a))),
      b_(plain_values(LocalMap(poses.b))),
      bound_scale_(bound_scale),
      // Runs before the kernel's first call, so that a forced target takes effect.
      pays_(simd_target() != SimdTarget::Scalar) {}

void CrossingPoints::compute(std::span<const PairCorners> pairs) {
    CD_CHECK(pairs.size() <= pairs_max);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        corners_.set(i, pairs[i].a, pairs[i].b);
    }
    find_crossings(a_, b_, bound_scale_, corners_, pairs.size(), found_);
}

} // namespace cd
