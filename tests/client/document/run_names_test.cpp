// Proves how a report names scenarios: by their ids, or in a scene by step, bodies and lines.
#include "client/document/run_names.hpp"

#include "common/geometry/mesh.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

class Names : public testing::Test {
  protected:
    Names() {
        job_.names = {"truck", "wall", "lines"};
        job_.meshes.assign(3, share(make_box({1, 1, 1})));
    }

    /// Makes a scene of two steps with a scenario each, of the truck and this body.
    void make_scene(std::uint32_t other, std::vector<std::uint64_t> record_steps) {
        StepIndex steps;
        steps.add_step({1});
        steps.add_step({1});
        steps.set_times({0.5, 1.5});
        job_.scene = JobScene{{}, {}, std::make_shared<const StepIndex>(steps), {}};
        std::vector<Scenario> scenarios(2);
        for (std::size_t i = 0; i < scenarios.size(); ++i) {
            scenarios[i].index = i;
            scenarios[i].body_b = other;
            scenarios[i].step = record_steps[i];
        }
        job_.poses = make_list_source(scenarios);
    }

    RunManifest manifest_;
    PreparedJob job_;
    const RunNames names_{manifest_, job_};
};

} // namespace

TEST_F(Names, AScenarioHasItsNumberIdAndTimes) {
    EXPECT_EQ(names_.label_of(3), "#3");
    job_.labels.integers = {7, 8};
    EXPECT_EQ(names_.name_of(1), "#1, id 8");
    job_.labels.integers.clear();
    job_.labels.texts = {"left", "right"};
    job_.labels.times = {0, 0.5};
    EXPECT_EQ(names_.label_of(1), "#1, id right, t 0.5");
    job_.labels.end_times = {0.5, 1};
    EXPECT_EQ(names_.label_of(1), "#1, id right, t 0.5 to 1");
}

TEST_F(Names, AScenarioOfASceneHasItsStepAndItsBodies) {
    make_scene(1, {0, 1});
    EXPECT_EQ(names_.name_of(1), "#1, step 1, truck x wall");
    EXPECT_EQ(names_.label_of(1), "#1, step 1, truck x wall, t 1.5");
}

TEST_F(Names, ABundleOfLinesThroughASceneHasItsBodyAndItsId) {
    ShotsSpec shots;
    shots.grid.spacing = 0.25;
    shots.grid.tile = 8;
    shots.azimuth_deg = {0, 90, 2};
    shots.elevation_deg = {15, 15, 1};
    shots.box = Aabb{Vec3(-1, -1, -1), Vec3(1, 1, 1)};
    job_.spec.scene.emplace();
    job_.spec.scene->shots = shots;
    const ShotViews views(shots, *shots.box);
    make_scene(2, {0, views.bundles() + 1});
    EXPECT_EQ(names_.name_of(0), "#0, step 0, truck, " + views.id_of(0));
    EXPECT_TRUE(views.id_of(0).starts_with("az=0 el=15 tile="));
    EXPECT_EQ(names_.label_of(1), "#1, step 1, truck, " + views.id_of(1) + ", t 1.5");
}

} // namespace cd::tests
