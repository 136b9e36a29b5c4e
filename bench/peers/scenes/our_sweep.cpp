#include "bench/peers/scenes/sweep_engine.hpp"

namespace cd::bench {

namespace {

/// What a job of a scene does at each step.
class OurSweep final : public BroadPhase {
  public:
    void load(const CrowdScene& scene) override {
        bodies_ = &scene.boxes;
        boxes_.resize(scene.boxes.size());
    }

    const std::vector<BodyPair>& step(const std::vector<Pose>& poses) override {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            boxes_[i] = world_box((*bodies_)[i].box, poses[i]);
        }
        pairs_ = overlapping_pairs(boxes_);
        return pairs_;
    }

  private:
    const std::vector<PosedBox>* bodies_ = nullptr;
    std::vector<WorldBox> boxes_;
    std::vector<BodyPair> pairs_;
};

} // namespace

SweepEngine our_sweep() {
    return {"cdcluster", true, [] { return std::make_unique<OurSweep>(); }};
}

} // namespace cd::bench
