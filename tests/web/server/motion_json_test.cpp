// Proves that the JSON of a motion has what its record and its keys have, number by number.
#include "web/server/motion_json.hpp"

#include "tests/support/motions.hpp"
#include "web/server/page_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace cd::tests {

namespace {

using Json = nlohmann::ordered_json;

ScenarioView view_of_motion() {
    ScenarioView view;
    view.keys = MotionKeys{
        {moved_pose({0, 0, 0}), moved_pose({2, 0, 0.1})},
        {moved_pose({0, 0, 1}), Pose::from_quaternion({0.5, -0.25, 0.125, 1}, Vec3(-2, 0, 0))}};
    ScenarioResult result;
    result.question = Question::Motion;
    result.level = Level::Any;
    result.kind = ScenarioClass::Contact;
    result.motion = MotionOutcome{Until::Contact, 5, MotionEnd::Contact, 7, 9, {}};
    result.motion->runs = {{CellState::Free, 0, 7}, {CellState::Open, 7, 2, 9, 9}};
    view.result = result;
    return view;
}

Json json_of(const ScenarioView& view) {
    return Json::parse(scenario_json(3, view));
}

TEST(MotionJson, HasTheOutcomeAndItsRuns) {
    const Json motion = json_of(view_of_motion()).at("motion");
    EXPECT_EQ(motion.at("end"), "contact");
    EXPECT_EQ(motion.at("until"), "contact");
    EXPECT_EQ(motion.at("depth"), 5);
    EXPECT_EQ(motion.at("t0"), 7);
    EXPECT_EQ(motion.at("t1"), 9);
    EXPECT_EQ(motion.at("event"), 9);
    EXPECT_TRUE(motion.at("bound").is_null());
    const Json& runs = motion.at("runs");
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].dump(),
              R"({"state":"free","first":0,"count":7,"event_first":null,"event_last":null})");
    EXPECT_EQ(runs[1].dump(),
              R"({"state":"open","first":7,"count":2,"event_first":9,"event_last":9})");
}

TEST(MotionJson, HasTheKeysExactly) {
    const Json motion = json_of(view_of_motion()).at("motion");
    EXPECT_EQ(motion.at("from").at("a"), Json::parse("[1.0,0.0,0.0,0.0,0.0,0.0,0.0]"));
    EXPECT_EQ(motion.at("from").at("b").at(6).get<double>(), 0.1);
    EXPECT_EQ(motion.at("to").at("a").at(6), 1.0);
    EXPECT_EQ(motion.at("to").at("b"), Json::parse("[0.5,-0.25,0.125,1.0,-2.0,0.0,0.0]"));
}

TEST(MotionJson, TellsTheBoundOfUndecidedOnesAlone) {
    ScenarioView view = view_of_motion();
    view.result->kind = ScenarioClass::Undecided;
    view.result->motion = MotionOutcome{Until::Free, 5, MotionEnd::Contact, 32, 32, {}};
    view.result->motion->runs = {{CellState::Open, 0, 32}};
    view.result->distance_bound = 0.25;
    EXPECT_EQ(json_of(view).at("motion").at("bound"), 0.25);
    EXPECT_TRUE(json_of(view).at("motion").at("event").is_null());
    EXPECT_EQ(json_of(view).at("motion").at("until"), "free");
    view.result->distance_bound = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(json_of(view).at("motion").at("bound").is_null());
}

TEST(MotionJson, OnlyAMotionHasIt) {
    ScenarioView view = view_of_motion();
    view.result->motion.reset(); // It failed.
    EXPECT_FALSE(json_of(view).contains("motion"));
    view.result.reset();
    EXPECT_FALSE(json_of(view).contains("motion"));
}

TEST(MotionJson, AJobTellsItsQuestion) {
    JobView job;
    job.query.question = Question::Motion;
    job.query.motion = MotionQuery{0.01, Until::End};
    const Json json = Json::parse(job_view_json(job));
    EXPECT_EQ(json.at("question"), "motion");
    EXPECT_EQ(json.at("resolution"), 0.01);
    EXPECT_EQ(json.at("until"), "end");
}

} // namespace

} // namespace cd::tests
