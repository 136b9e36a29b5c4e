// Motions of one body onto another, and past it, for benchmarks.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/motion/motion_bound.hpp"

#include <string>
#include <vector>

namespace cd::bench {

struct MotionPathOptions {
    double length = 3;          ///< Of each path, in A's unit.
    double degrees = 30;        ///< B's turn on each path, about the world's z axis.
    double resolution = 0.0005; ///< In A's unit.
};

/// A motion between two keys, which are on a grid (`round_keys`).
struct KeyedPath {
    std::string kind; ///< "onto" or "past".
    PosePair from;
    PosePair to;
};

/// Returns the path between two keys once they are rounded. Errors: those of `round_keys`.
[[nodiscard]] Result<KeyedPath> keyed_path(const std::string& kind,
                                           const PosePair& from,
                                           const PosePair& to,
                                           const BodyRadii& radii,
                                           double resolution);

/// Makes motions of two meshes.
class MotionPaths {
  public:
    MotionPaths(const Mesh& a, const Mesh& b, const MotionPathOptions& options);

    /// Returns two paths: `onto` ends at the pose, coming from where A's centre is behind B; `past`
    /// goes sideways through the pose moved away from A by a fiftieth of B's diagonal. Errors:
    /// those of `round_keys`.
    [[nodiscard]] Result<std::vector<KeyedPath>> paths_of(const PosePair& poses) const;

    [[nodiscard]] const BodyRadii& radii() const { return radii_; }

  private:
    MotionPathOptions options_;
    Vec3 center_a_;
    Aabb box_b_;
    BodyRadii radii_;
};

} // namespace cd::bench
