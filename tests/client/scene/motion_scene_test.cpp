// Proves that a job with [bodies] and [motion] becomes motions from each step to the next, and that
// `cdctl job check` says what is tested of them.
#include "client/job/job_text.hpp"
#include "client/scene/prepared_scene.hpp"
#include "client/scene/scene_check.hpp"
#include "common/scene/swept_box.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A tetrahedron at the origin, of size 1.
constexpr const char* small_body = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                   "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
const std::string motion = "[motion]\nresolution = 0.125\n";

class MotionScene : public testing::Test {
  protected:
    MotionScene() {
        write_text(folder_ / "car.obj", small_body);
        // car.0 passes car.1 between the steps 0 and 1; car.2 is there at the first two steps.
        write_text(folder_ / "poses.csv",
                   "step,body,x,y,t\n0,car.0,-8,0,0\n0,car.1,0,0,0\n0,car.2,0,40,0\n"
                   "1,car.0,8,0,2\n1,car.1,0,0,2\n1,car.2,1,40,2\n"
                   "2,car.0,9,0,3\n2,car.1,0,0,3\n2,car.2,nan,nan,3\n");
    }

    /// Reads a job whose [motion] and further tables begin in line 8.
    [[nodiscard]] Result<JobSpec> read(const std::string& more) const {
        write_text(folder_ / "job.toml",
                   "[bodies]\ncar = { mesh = \"car.obj\", count = 3 }\n"
                   "post = { mesh = \"car.obj\", pose = [0, 0.5, 0, 0, 0, 0, 1], quat_order = "
                   "\"xyzw\" }\nwall = { mesh = \"car.obj\", pose = [0, 1, 0, 0, 0, 0, 1], "
                   "quat_order = \"xyzw\" }\n[poses]\nfile = \"poses.csv\"\nabsent = \"nan\"\n" +
                       more);
        return read_job_file(folder_ / "job.toml");
    }
    [[nodiscard]] PreparedScene prepared(const std::string& more) const {
        const auto spec = read(more);
        EXPECT_TRUE(spec) << spec.error().detail;
        auto made = prepare_scene(spec.value(), true);
        EXPECT_TRUE(made) << made.error().detail;
        return std::move(made.value());
    }
    [[nodiscard]] std::string problem_of(const std::string& more) const {
        const auto spec = read(more);
        if (!spec) {
            return spec.error().detail;
        }
        const auto made = prepare_scene(spec.value(), true);
        return made ? "none" : made.error().detail;
    }

    const TemporaryFolder folder_;
};

} // namespace

TEST_F(MotionScene, HasMotionsFromEachStepToTheNext) {
    const PreparedScene scene = prepared(motion);
    const auto steps = scene.steps;
    ASSERT_EQ(steps->steps(), 2u);
    // From step 0 to 1, car.0 sweeps over car.1, post and wall; these three touch each other.
    EXPECT_EQ(steps->coverage()[0], (StepCoverage{6, 4, 0, 0, 0}));
    EXPECT_EQ(steps->coverage()[1], (StepCoverage{2, 3, 0, 1, 4}));
    EXPECT_EQ(scene.facts.absences[2], 1u);
    EXPECT_EQ(steps->time_at(0, 0.5), 1.0);
    EXPECT_EQ(steps->time_at(1, 0.5), 2.5);
    const auto scenarios = scene.poses->read(0, 1).value();
    EXPECT_EQ(scenarios[0].poses.a.translation(), Vec3(-8, 0, 0));
    ASSERT_TRUE(scenarios[0].to);
    EXPECT_EQ(scenarios[0].to->a.translation(), Vec3(8, 0, 0));
    EXPECT_EQ(scenarios[0].to->b, scenarios[0].poses.b);
    // Without [motion] the three steps are tested, and car.0 meets nobody.
    const PreparedScene at_rest = prepared("");
    EXPECT_EQ(at_rest.steps->steps(), 3u);
    const auto resting = at_rest.poses->read(0, at_rest.poses->count()).value();
    EXPECT_FALSE(resting.empty());
    for (const Scenario& scenario : resting) {
        EXPECT_NE(scenario.body_a, 0u);
        EXPECT_FALSE(scenario.to);
    }
}

TEST_F(MotionScene, ReachesAsFarAsTheResolutionAndTheClearance) {
    Query query;
    query.question = Question::Motion;
    query.motion = MotionQuery{0.125};
    EXPECT_EQ(reach_of(query), reach_of_motions(0, 0.125));
    EXPECT_GE(reach_of(query), 0.125);
    query.clearance = 2;
    EXPECT_GE(reach_of(query), 2.125);
    EXPECT_LE(reach_of(query), 2.1251);
    // car.2 is 38 from the wall in y.
    EXPECT_EQ(
        prepared(motion + "[query]\nlevel = \"any\"\nclearance = 39\n").steps->coverage()[0].apart,
        0u);
}

TEST_F(MotionScene, ItsHeadIsNotThatOfTheStepsAtRest) {
    EXPECT_NE(prepared(motion).head, prepared("").head);
    EXPECT_EQ(prepared(motion).head, prepared("[motion]\nresolution = 0.5\n").head);
}

TEST_F(MotionScene, TheCheckCountsItsStepsAndTellsOfTheRounding) {
    const auto spec = read(motion);
    ASSERT_TRUE(spec);
    const auto scene = prepare_scene(spec.value(), true);
    ASSERT_TRUE(scene) << scene.error().detail;
    EXPECT_THAT(
        check_text(spec.value(), scene.value()),
        AllOf(HasSubstr("2 steps of motion, 8 scenarios:\n"
                        "  8 of 20 pairs tested, 7 apart by their boxes, 1 of fixed bodies, 4 of "
                        "an absent body\n"),
              HasSubstr("  absent: car.2 at 1 step\n"),
              HasSubstr("keys of motions are rounded to a grid: rounding moved no body by more "
                        "than ")));
    EXPECT_EQ(keys_text(1.0 / 1024, "mm"),
              "keys of motions are rounded to a grid: rounding moved no body by more than 0.00098 "
              "mm");
}

TEST_F(MotionScene, ReadsTheSameFromItsOwnText) {
    const auto spec = read(motion + "until = \"end\"\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().query.motion, (MotionQuery{0.125, Until::End}));
    const auto again = parse_job(job_text(spec.value()), folder_ / "job.toml");
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(again.value().query.motion, spec.value().query.motion);
    EXPECT_TRUE(again.value().scene);
}

TEST_F(MotionScene, FollowsVelocitiesByKeysBetweenTheSteps) {
    // car.0 flies over car.1 in a curve: straight from step to step it would go through it.
    write_text(folder_ / "poses.csv",
               "step,body,x,z,t,vx,vy,vz,ax,ay,az\n0,car.0,-8,0,0,8,0,8,0,0,-8\n"
               "0,car.1,0,0,0,0,0,0,0,0,0\n0,car.2,0,0,0,0,0,0,0,0,0\n"
               "1,car.0,8,0,2,0,0,0,0,0,0\n1,car.1,0,0,2,0,0,0,0,0,0\n"
               "1,car.2,nan,nan,2,nan,nan,nan,nan,nan,nan\n");
    const PreparedScene curved = prepared(motion + "chord = 0.01\n");
    EXPECT_GT(curved.steps->steps(), 10u);
    EXPECT_EQ(curved.query.clearance, 0.01);
    ASSERT_EQ(curved.facts.notes.size(), 1u);
    EXPECT_THAT(curved.facts.notes[0],
                AllOf(HasSubstr("2 steps became "),
                      HasSubstr("within 0.01 m, by which the clearance grows")));
    const auto steps = curved.steps;
    EXPECT_EQ(steps->time_at(steps->steps() - 1, 1), 2.0);
    // Its path is straight within the resolution where a chord is not given.
    EXPECT_EQ(prepared(motion).query.clearance, std::nullopt);
    EXPECT_GT(prepared(motion).steps->steps(), steps->steps() / 3);
    EXPECT_THAT(prepared("").facts.notes.at(0), HasSubstr("velocities count with [motion] alone"));
    EXPECT_THAT(problem_of(motion + "chord = 1e-13\n"), HasSubstr("numbers of 64 bits"));
    const auto spec = read(motion + "chord = 0.01\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_THAT(check_text(spec.value(), curved), HasSubstr("  2 steps became "));
    EXPECT_EQ(parse_job(job_text(spec.value()), folder_ / "job.toml").value().chord, 0.01);
}

TEST_F(MotionScene, WhatIsNoMotionIsRefused) {
    EXPECT_THAT(problem_of(motion + "chord = 0.1\n"),
                HasSubstr("job.toml:10: [motion]: chord is for line, arc, screw and drive, and for "
                          "files of poses with velocities"));
    EXPECT_THAT(problem_of(motion + "[query]\nlevel = \"distance\"\nup_to = 1\n"),
                HasSubstr("motions of [motion] are asked at level any or pairs"));
    write_text(folder_ / "poses.csv", "step,body,x\n0,car.0,0\n0,car.1,2\n0,car.2,4\n");
    EXPECT_THAT(problem_of(motion),
                AllOf(HasSubstr("job.toml:8: [motion] leads from one step to the next"),
                      HasSubstr("two steps or more")));
    write_text(folder_ / "poses.csv",
               "step,body,x,yaw_rad\n0,car.0,0,0\n0,car.1,2,0\n0,car.2,4,0\n"
               "1,car.0,0,0\n1,car.1,2,3.141592653589793\n1,car.2,4,0\n");
    EXPECT_THAT(problem_of(motion),
                HasSubstr("step 0: car.1: two keys of a motion are turned by 180 degrees"));
    write_text(folder_ / "poses.csv",
               "step,body,x\n0,car.0,0\n0,car.1,2\n0,car.2,4\n1,car.0,1e6\n1,car.1,2\n1,car.2,4\n");
    EXPECT_THAT(problem_of(motion),
                HasSubstr("step 0: car.0 and car.1: the bodies move too far between two keys"));
}

} // namespace cd::tests
