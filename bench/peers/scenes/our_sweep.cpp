#include "bench/peers/scenes/sweep_engine.hpp"
#include "common/scene/world_boxes.hpp"

namespace cd::bench {

namespace {

/// What a job of a scene does at each step.
class OurSweep final : public BroadPhase {
  public:
    void load(const CrowdScene& scene) override { bodies_ = &scene.boxes; }

    const std::vector<BodyPair>& step(const std::vector<Pose>& poses) override {
        WorldBoxes boxes(poses.size());
        for (std::size_t i = 0; i < poses.size(); ++i) {
            boxes.add((*bodies_)[i].box, poses[i]);
        }
        pairs_ = overlapping_pairs(boxes.take());
        return pairs_;
    }

  private:
    const std::vector<PosedBox>* bodies_ = nullptr;
    std::vector<BodyPair> pairs_;
};

} // namespace

SweepEngine our_sweep() {
    return {"cdcluster", true, [] { return std::make_unique<OurSweep>(); }};
}

} // namespace cd::bench
