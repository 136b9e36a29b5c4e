// Proves that the comparison of broad phases counts the pairs that an engine lacks, and that ours
// lacks none of moving boxes.
#include "bench/peers/scenes/contest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::tests {
namespace {

using namespace cd::bench;

/// Our engine without the first of its pairs.
class Forgetful final : public BroadPhase {
  public:
    void load(const CrowdScene& scene) override { ours_->load(scene); }
    const std::vector<BodyPair>& step(const std::vector<Pose>& poses) override {
        pairs_ = ours_->step(poses);
        pairs_.erase(pairs_.begin());
        return pairs_;
    }

  private:
    std::unique_ptr<BroadPhase> ours_ = our_sweep().make();
    std::vector<BodyPair> pairs_;
};

TEST(SceneContest, CountsPairsThatAreMissing) {
    const std::vector<BodyPair> wanted{{0, 1}, {0, 2}, {3, 4}};

    EXPECT_EQ(count_missing(wanted, {{3, 4}, {0, 2}, {0, 1}, {5, 6}}), 0);
    EXPECT_EQ(count_missing(wanted, {{0, 2}}), 2);
    EXPECT_EQ(pair_of(7, 3), (BodyPair{3, 7}));
}

TEST(SceneContest, OursLacksNoPairOfMovingBoxes) {
    CrowdScene scene{"assembly", make_assembly(100), {}};
    scene.steps = moving_poses(scene.boxes, 5, Vec3(0.1, 0.1, 0.1), 0.5);
    ASSERT_NE(all_overlapping_pairs(scene, scene.steps.front()),
              all_overlapping_pairs(scene, scene.steps.back()));
    const std::vector<SweepEngine> engines{
        our_sweep(), {"forgetful", false, [] { return std::make_unique<Forgetful>(); }}};

    const auto outcomes = run_sweep_contest(scene, engines, {.rounds = 1});

    EXPECT_EQ(outcomes[0].missing, 0);
    EXPECT_EQ(outcomes[0].step_seconds.size(), 5);
    EXPECT_EQ(outcomes[1].missing, 2) << "one at each of the two steps that are compared";
    EXPECT_EQ(outcomes[1].pairs, outcomes[0].pairs - 5);
}

} // namespace
} // namespace cd::tests
