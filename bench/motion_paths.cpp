#include "bench/motion_paths.hpp"

#include "common/core/errors.hpp"
#include "common/motion/motion_keys.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace cd::bench {

namespace {

/// Returns the pose turned about z and moved.
Pose after(const Pose& pose, double degrees, const Vec3& move) {
    const double half = degrees * (3.14159265358979323846 / 360);
    const Quaternion turn{std::cos(half), 0, 0, std::sin(half)};
    return Pose::from_quaternion(turn * pose.quaternion(), pose.translation() + move);
}

} // namespace

Result<KeyedPath> keyed_path(const std::string& kind,
                             const PosePair& from,
                             const PosePair& to,
                             const BodyRadii& radii,
                             double resolution) {
    const RoundedKeys rounded = CD_TRY(round_keys(std::array{from, to}, radii, resolution));
    return KeyedPath{kind, rounded.keys[0], rounded.keys[1]};
}

MotionPaths::MotionPaths(const Mesh& a, const Mesh& b, const MotionPathOptions& options)
    : options_(options),
      center_a_(bounding_box(a.vertices()).center()),
      box_b_(bounding_box(b.vertices())),
      radii_{body_radius(a.vertices()), body_radius(b.vertices())} {}

Result<std::vector<KeyedPath>> MotionPaths::paths_of(const PosePair& poses) const {
    const Pose b = CD_TRY(unit_key(poses.b));
    const Vec3 away = (b.apply(box_b_.center()) - center_a_).normalized();
    const Vec3 sideways = away.unitOrthogonal();
    const Vec3 beside = box_b_.diagonal() / 50 * away;
    const double half = options_.length / 2;
    const double degrees = options_.degrees;
    const KeyedPath onto = CD_TRY(keyed_path("onto",
                                             {poses.a, after(b, -degrees, options_.length * away)},
                                             {poses.a, b},
                                             radii_,
                                             options_.resolution));
    const KeyedPath past =
        CD_TRY(keyed_path("past",
                          {poses.a, after(b, -degrees / 2, beside - half * sideways)},
                          {poses.a, after(b, degrees / 2, beside + half * sideways)},
                          radii_,
                          options_.resolution));
    return std::vector<KeyedPath>{onto, past};
}

} // namespace cd::bench
