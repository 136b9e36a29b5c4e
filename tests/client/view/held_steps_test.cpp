// Proves that a report holds all that the page requests to show the bodies of a step: their poses,
// and each mesh once. Also proves that the report counts and leaves out what has no room.
#include "client/view/held_steps.hpp"

#include "tests/client/view/asked_server.hpp"
#include "tests/client/view/viewed_scene.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

/// Three steps: all three bodies meet at the first two, only the balls at the last.
constexpr const char* three_steps = "step,body,x\n0,ball.0,0.5\n0,ball.1,1\n1,ball.0,0.4\n"
                                    "1,ball.1,1\n2,ball.0,9\n2,ball.1,10\n";

class HeldSteps : public Viewed {
  protected:
    /// Offers the steps of these scenarios; takes answers whose paths `is_taken`.
    template <class IsTaken>
    LeftOut offer(ViewedRun& run, std::vector<std::uint64_t> scenarios, IsTaken is_taken) {
        const auto take = [&](std::span<const HeldAnswer> answers) {
            const bool takes = is_taken(answers.front().path);
            for (const HeldAnswer& each : answers) {
                takes ? answers_.push_back(each) : void();
            }
            return takes;
        };
        const auto left_out = offer_steps(run, "folder", scenarios, take, never());
        EXPECT_TRUE(left_out);
        return left_out ? left_out.value() : LeftOut();
    }

    [[nodiscard]] std::vector<std::string> paths() const {
        std::vector<std::string> found;
        for (const HeldAnswer& each : answers_) {
            found.push_back(each.path);
        }
        return found;
    }

    std::vector<HeldAnswer> answers_;
};

bool take_all(const std::string&) {
    return true;
}

TEST_F(HeldSteps, AreWhatTheServerAnswers) {
    auto run = view_scene(three_steps, make_torus(0.5, 0.2, 12, 8));
    ASSERT_EQ(run->count(), 7u);
    const LeftOut left_out = offer(*run, {0, 6}, take_all);
    EXPECT_TRUE(left_out.is_empty());
    EXPECT_THAT(paths(),
                ElementsAre("jobs/folder/steps?first=0&count=2",
                            "jobs/folder/bodies?first=0&count=3",
                            "jobs/folder/classes?first=0&count=3",
                            "jobs/folder/poses?first=0&count=3",
                            "jobs/folder/steps?first=2&count=1",
                            "jobs/folder/bodies?first=6&count=1",
                            "jobs/folder/classes?first=6&count=1",
                            "jobs/folder/poses?first=6&count=1",
                            StartsWith("meshes/")))
        << "the torus is a third body's; that of the balls is held for the pair";
    Server server(std::move(run));
    for (const HeldAnswer& each : answers_) {
        EXPECT_TRUE(each.bytes == server.ask(each.path).bytes) << each.path;
    }
}

TEST_F(HeldSteps, OfMotionsHaveTheKeysOfAllBodies) {
    auto run = view_scene(three_steps, make_sphere(1), "[motion]\nresolution = 0.1\n");
    EXPECT_TRUE(offer(*run, {0}, take_all).is_empty());
    ASSERT_EQ(answers_.size(), 4u);
    EXPECT_EQ(answers_.back().path, "jobs/folder/keys?first=0&count=3");
    const auto keys = run->keys({0, 3});
    ASSERT_TRUE(keys) << keys.error().detail;
    EXPECT_NEAR(keys.value()[0].from.a.translation().x(), 0.5, 1e-9) << "ball.0 at step 0";
    EXPECT_NEAR(keys.value()[0].to.a.translation().x(), 0.4, 1e-9) << "at step 1";
    EXPECT_EQ(run->keys({0, 99}).error().code, ErrorCode::BadInput);
    Server server(std::move(run));
    for (const HeldAnswer& each : answers_) {
        EXPECT_TRUE(each.bytes == server.ask(each.path).bytes) << each.path;
    }
}

TEST_F(HeldSteps, OfOneStepAreOfferedOnce) {
    auto run = view_scene(three_steps);
    EXPECT_TRUE(offer(*run, {3, 4, 5}, take_all).is_empty());
    EXPECT_EQ(answers_.size(), 4u) << "all bodies have the mesh of the pair";
    EXPECT_EQ(answers_.front().path, "jobs/folder/steps?first=1&count=2");
}

TEST_F(HeldSteps, WithoutRoomAreCounted) {
    auto run = view_scene(three_steps, make_torus(0.5, 0.2, 12, 8));
    const LeftOut meshes =
        offer(*run, {0, 3}, [](const std::string& path) { return !path.starts_with("meshes/"); });
    EXPECT_EQ(answers_.size(), 8u);
    EXPECT_EQ(meshes.text(), "1 mesh, drawn as boxes");
    answers_.clear();
    const LeftOut steps =
        offer(*run, {0, 3}, [](const std::string& path) { return path.starts_with("meshes/"); });
    EXPECT_EQ(steps.text(), "the other bodies of 2 steps");
    EXPECT_TRUE(answers_.empty()) << "a step that is not shown needs no mesh";
    EXPECT_EQ((LeftOut{1, 2}).text(), "the other bodies of 1 step, and 2 meshes, drawn as boxes");
}

TEST_F(HeldSteps, OfTwoBodiesAreNone) {
    auto run = view("level = \"pairs\"\n");
    EXPECT_TRUE(offer(*run, {0, 1}, take_all).is_empty());
    EXPECT_TRUE(answers_.empty());
}

TEST_F(HeldSteps, OnlyBodiesOfTheScenariosHaveMeshAndParts) {
    auto run = view_scene(three_steps, make_torus(0.5, 0.2, 12, 8));
    const auto take = [&](const HeldAnswer& answer) {
        answers_.push_back(answer);
        return Status(Done{});
    };
    const std::vector<std::uint64_t> last{6};
    EXPECT_TRUE(for_each_answer(*run, folder_origin(*run), last, take, never()));
    EXPECT_THAT(paths(),
                ElementsAre("source",
                            "jobs/folder",
                            StartsWith("meshes/"),
                            "jobs/folder/parts/0",
                            "jobs/folder/parts/0/names",
                            "jobs/folder/parts/1",
                            "jobs/folder/parts/1/names",
                            "jobs/folder/scenarios/6",
                            "jobs/folder/scenarios/6/pairs",
                            "jobs/folder/scenarios/6/points"));
}

TEST_F(HeldSteps, EndWithASignal) {
    auto run = view_scene(three_steps);
    const auto take = [](std::span<const HeldAnswer>) { return true; };
    const std::vector<std::uint64_t> first{0};
    const auto told = offer_steps(*run, "folder", first, take, [] { return true; });
    EXPECT_EQ(told.error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace cd::tests
