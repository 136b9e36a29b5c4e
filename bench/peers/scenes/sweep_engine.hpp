// A common interface of engines that find the pairs of moving boxes that may touch.
#pragma once

#include "bench/box_crowds.hpp"
#include "common/scene/box_sweep.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

/// Boxes that move, step by step.
struct CrowdScene {
    std::string name;
    std::vector<PosedBox> boxes;
    std::vector<std::vector<Pose>> steps; ///< The poses of all boxes at each step.
};

/// The broad phase of a scene.
class BroadPhase {
  public:
    BroadPhase() = default;
    BroadPhase(const BroadPhase&) = delete;
    BroadPhase& operator=(const BroadPhase&) = delete;
    virtual ~BroadPhase() = default;

    /// Takes the boxes in their poses at the first step. They outlive this object.
    virtual void load(const CrowdScene& scene) = 0;
    /// Moves all boxes, and returns the pairs that are left, in any order and valid until the next
    /// call.
    [[nodiscard]] virtual const std::vector<BodyPair>& step(const std::vector<Pose>& poses) = 0;
};

/// An engine with one setting.
struct SweepEngine {
    std::string name;
    bool is_ours = false;
    std::function<std::unique_ptr<BroadPhase>()> make;
};

/// Returns a pair in order.
[[nodiscard]] inline BodyPair pair_of(std::size_t i, std::size_t j) {
    return {static_cast<std::uint32_t>(i < j ? i : j), static_cast<std::uint32_t>(i < j ? j : i)};
}

/// Appends FCL's managers: the dynamic tree of AABBs, and sweep and prune.
void add_fcl_sweeps(std::vector<SweepEngine>& engines);

/// Appends Bullet's btDbvtBroadphase.
void add_bullet_sweeps(std::vector<SweepEngine>& engines);

/// Returns our engine.
[[nodiscard]] SweepEngine our_sweep();

} // namespace cd::bench
