// A common interface of engines that find when a moving body meets another one.
#pragma once

#include "bench/motion_paths.hpp"
#include "common/geometry/mesh.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

/// Two bodies, and paths between keys.
struct MotionScene {
    std::string name;
    std::shared_ptr<const Mesh> a;
    std::shared_ptr<const Mesh> b;
    double resolution = 0; ///< Of ours: how far bodies move in a part of time that stays open.
    double length = 0;     ///< Of each path.
    std::vector<KeyedPath> paths;
};

/// When two bodies meet on a path, in [0, 1]; engines but ours tell one time, t0 = t1.
struct Impact {
    enum class Kind { None, Found, Undecided };
    Kind kind = Kind::None;
    double t0 = 0;
    double t1 = 0;
};

/// Two bodies, and when they meet.
class MotionBodies {
  public:
    MotionBodies() = default;
    MotionBodies(const MotionBodies&) = delete;
    MotionBodies& operator=(const MotionBodies&) = delete;
    virtual ~MotionBodies() = default;

    /// Builds everything that is built once for two bodies. The scene outlives this object.
    virtual void load(const MotionScene& scene) = 0;
    [[nodiscard]] virtual Impact find(const KeyedPath& path) = 0;
};

/// An engine with one setting.
struct MotionEngine {
    std::string name;
    bool is_ours = false;
    std::function<std::unique_ptr<MotionBodies>()> make_bodies;
};

/// Appends FCL's continuousCollide: conservative advancement with trees of swept spheres, alone and
/// with boxes, and samples of the path. Its motion is linear, with a constant angular velocity.
void add_fcl_motions(std::vector<MotionEngine>& engines);

/// Appends Bullet's convexSweepTest of the bodies' convex hulls.
void add_bullet_motions(std::vector<MotionEngine>& engines);

/// Returns our engine.
[[nodiscard]] MotionEngine our_motions();

} // namespace cd::bench
