// Proves what the page gets of a run of a scene: steps, bodies, poses in the world, and the next
// contact of one body.
#include "tests/client/view/viewed_scene.hpp"
#include "web/server/page_json.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two balls, both in contact with a fixed third one at step 1, and not with one another; one of
/// them is in contact at step 0, too.
class ViewedPlaces : public Viewed {
  protected:
    std::unique_ptr<ViewedRun> view_balls() {
        return view_scene("step,t,body,x,y,z\n0,0.5,ball.0,1.5,0,0\n0,0.5,ball.1,9,0,0\n"
                          "1,2,ball.0,1.5,0,0\n1,2,ball.1,0,1.5,0\n");
    }
};

} // namespace

TEST_F(ViewedPlaces, ScenariosHaveStepsAndBodies) {
    const auto run = view_balls();
    const auto places = run->places({0, run->count()});
    ASSERT_TRUE(places) << places.error().detail;
    ASSERT_THAT(
        places.value(),
        ElementsAre(
            ScenePlace{0, 0, 2}, ScenePlace{1, 0, 1}, ScenePlace{1, 0, 2}, ScenePlace{1, 1, 2}));
    EXPECT_THAT(run->places({0, 0, 2}).value(), ElementsAre(places.value()[0], places.value()[2]));
    EXPECT_THAT(run->steps({0, 2}).value(), ElementsAre(StepRow{0, 0.5}, StepRow{1, 2}));
    EXPECT_EQ(run->view("folder").steps, 2u);
    EXPECT_FALSE(run->places({1, 4}));
    EXPECT_FALSE(run->steps({1, 2}));
}

TEST_F(ViewedPlaces, PosesAreThoseOfBothBodiesInTheWorld) {
    const auto run = view_balls();
    const PoseRows rows = run->poses({3, 1}).value();
    EXPECT_EQ(rows.poses_each, 2u);
    ASSERT_EQ(rows.numbers.size(), 24u);
    EXPECT_EQ(rows.numbers[7], 1.5);
    EXPECT_EQ(rows.numbers[15], 0);
    EXPECT_TRUE(run->view("folder").poses.of_both_bodies);
}

TEST_F(ViewedPlaces, AScenarioTellsItsStepTimeAndBodies) {
    const auto run = view_balls();
    const auto scenario = run->scenario(3, never());
    ASSERT_TRUE(scenario) << scenario.error().detail;
    const auto json = nlohmann::json::parse(scenario_json(3, *scenario.value()));
    EXPECT_EQ(json["step"], 1);
    EXPECT_EQ(json["time"], 2);
    EXPECT_EQ(json["bodies"], (nlohmann::json{1, 2}));
    EXPECT_EQ(json["verified"], true);
}

TEST_F(ViewedPlaces, TheNextContactIsOfTheWantedBody) {
    const auto run = view_balls();
    const auto next = [&](std::uint64_t from, const std::string& body) {
        NextContact wanted{from};
        wanted.body = body;
        return run->next(wanted);
    };
    EXPECT_EQ(next(0, "").value().scenario, 2u) << "the two moving balls do not touch";
    EXPECT_EQ(next(0, "ball.1").value().scenario, 3u);
    EXPECT_EQ(next(0, "2").value().scenario, 2u);
    EXPECT_EQ(next(2, "ball.0").value().scenario, std::nullopt);
    EXPECT_THAT(next(0, "lorry").error().detail, HasSubstr("no body 'lorry'"));
}

TEST_F(ViewedPlaces, ARunOfTwoBodiesHasNoSteps) {
    const auto run = view("level = \"any\"\n");
    EXPECT_EQ(run->places({0, 1}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run->steps({0, 1}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(run->view("folder").steps, std::nullopt);
    EXPECT_FALSE(nlohmann::json::parse(job_view_json(run->view("folder"))).contains("steps"));
}

} // namespace cd::tests
