// Proves that steps have their first scenarios and times, and scenarios their steps and bodies.
#include "web/server/scene/scene_rows.hpp"

#include "common/core/limits/web.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Three steps, the second without scenarios.
StepIndex three_steps() {
    StepIndex steps;
    steps.add_step({2});
    steps.add_step({0});
    steps.add_step({1});
    steps.set_times({0.5, 1, 2.5});
    return steps;
}

} // namespace

TEST(SceneRows, AStepHasItsFirstScenarioAndItsTime) {
    const StepIndex steps = three_steps();
    EXPECT_THAT(step_rows(steps, {0, 3}).value(),
                ElementsAre(StepRow{0, 0.5}, StepRow{2, 1}, StepRow{2, 2.5}));
    EXPECT_THAT(step_rows(steps, {2, 1}).value(), ElementsAre(StepRow{2, 2.5}));
    EXPECT_THAT(step_rows(steps, {0, 0, 2}).value(), ElementsAre(StepRow{0, 0.5}, StepRow{2, 1}));
    const auto beyond = step_rows(steps, {2, 2});
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.error().detail, "the job has 3 steps");
    EXPECT_FALSE(step_rows(steps, {0, limits::page_scenarios_max + 1}));
}

TEST(SceneRows, AScenarioHasItsStepAndItsBodies) {
    const StepIndex steps = three_steps();
    const std::vector<Scenario> scenarios{{0, 1, 3, {}, 0}, {2, 0, 2, {}, 2}};
    EXPECT_THAT(scene_places(scenarios, steps).value(),
                ElementsAre(ScenePlace{0, 1, 3}, ScenePlace{2, 0, 2}));
    const std::vector<Scenario> of_lines{{2, 0, 2, {}, 17}};
    EXPECT_THAT(scene_places(of_lines, steps).value(), ElementsAre(ScenePlace{2, 0, 2}))
        << "17 names the bundle, too";
    for (const Scenario& damaged : {Scenario{0, 1, 3, {}, {}}, Scenario{3, 1, 3, {}, 2}}) {
        const auto places = scene_places({&damaged, 1}, steps);
        ASSERT_FALSE(places);
        EXPECT_EQ(places.error().code, ErrorCode::BadFrame);
    }
}

TEST(SceneRows, AMotionHasItsKeys) {
    const auto at = [](double x) { return Pose::from_quaternion({1, 0, 0, 0}, Vec3(x, 0, 0)); };
    Scenario scenario{0, 0, 1, {at(1), at(2)}, 4};
    EXPECT_EQ(scene_motions(std::span(&scenario, 1)).error().code, ErrorCode::NotFound);
    scenario.to = PosePair{at(3), at(4)};
    const auto keys = scene_motions(std::span(&scenario, 1));
    ASSERT_TRUE(keys);
    ASSERT_EQ(keys.value().size(), 1u);
    EXPECT_EQ(keys.value()[0].from, (PosePair{at(1), at(2)}));
    EXPECT_EQ(keys.value()[0].to, (PosePair{at(3), at(4)}));
}

TEST(SceneRows, AViewGetsTheTimeOfItsStep) {
    const StepIndex steps = three_steps();
    ScenarioView view;
    add_step_time(&steps, 2, view);
    EXPECT_FALSE(view.time) << "of no scene";
    view.scene = ScenePlace{17, 0, 1};
    add_step_time(nullptr, 2, view);
    EXPECT_FALSE(view.time);
    add_step_time(&steps, 3, view);
    EXPECT_FALSE(view.time) << "there is no such scenario";
    add_step_time(&steps, 2, view);
    EXPECT_EQ(view.scene->step, 2u);
    EXPECT_EQ(view.time, 2.5);
}

TEST(SceneRows, ASubmittedSceneHasItsSteps) {
    Submit submit;
    submit.scenarios = 3;
    EXPECT_EQ(steps_of(submit).value(), nullptr);
    submit.poses.scene.emplace();
    submit.poses.scene->steps = pack_steps(three_steps());
    EXPECT_EQ(steps_of(submit).value()->steps(), 3u);
    submit.scenarios = 4;
    EXPECT_FALSE(steps_of(submit)) << "steps of another job";
}

} // namespace cd::tests
