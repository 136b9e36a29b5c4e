// Tests `search_effort`: it counts the cells that the search of a motion tests, and the pairs of
// roots that the search of a distance needs.
#include "master/compute/search_effort.hpp"

#include "common/job/run_scenario.hpp"
#include "common/motion/motion_bound.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

class Efforts : public testing::Test {
  protected:
    Efforts() {
        for (const Mesh& mesh : {make_sphere(4), make_box({0.2, 0.3, 0.4})}) {
            input_.trees.push_back(
                std::make_shared<const ObbTree>(build_tree(share(mesh), BuildOptions{}, pool_)));
            input_.tops.push_back(
                std::make_shared<const TreeTop>(cut_tree(*input_.trees.back(), 5)));
            input_.radii.push_back(body_radius(mesh.vertices()));
        }
        input_.query.level = Level::Any;
        scenario_.poses = {moved_pose(Vec3::Zero()), moved_pose({3, 0.25, 0})};
    }
    std::optional<SearchEffort> effort(const StopCheck& stop = [] { return false; }) {
        input_.settler =
            std::make_shared<const Settler>(TreesByBody(input_.trees), input_.query.ignored);
        analysis_ = analyse(input_, scenario_);
        return search_effort(input_, analysis_, stop);
    }
    void ask_for_motion(const Pose& to) {
        input_.query.question = Question::Motion;
        input_.query.motion = MotionQuery{0.0625, Until::Contact};
        scenario_.to = PosePair{moved_pose(Vec3::Zero()), to};
    }

    ThreadPool pool_{1};
    AnalysisInput input_;
    Scenario scenario_;
    Analysis analysis_;
};

TEST_F(Efforts, ADistanceNeedsFewOfTheRootsThatAreNamed) {
    input_.query.question = Question::Distance;
    const SearchEffort found = effort().value();
    EXPECT_EQ(found.roots_named, analysis_.pairs.size());
    EXPECT_GT(found.roots_used, 0u);
    EXPECT_LT(found.roots_used, found.roots_named);
    EXPECT_EQ(found.cells, 0u);
    scenario_.poses.b = moved_pose({1, 0, 0}); // In contact, so all pairs may touch.
    const SearchEffort touching = effort().value();
    EXPECT_EQ(touching.roots_used, touching.roots_named);
}

TEST_F(Efforts, AMotionPastTheBodyTestsOneCellAndOneIntoItHalvesMany) {
    ask_for_motion(moved_pose({3, 0.5, 0}));
    EXPECT_EQ(effort().value().cells, 1u);
    EXPECT_EQ(effort().value().leaves, 1u);
    EXPECT_EQ(analysis_.cost.search.effort, (SearchEffort{1, 1, 0, 0})) << "the master answers it";
    ask_for_motion(moved_pose({0, 0.25, 0}));
    const SearchEffort found = effort().value();
    EXPECT_GT(found.cells, 5u);
    EXPECT_LT(found.leaves, found.cells);
    EXPECT_EQ(analysis_.cost.search.effort, SearchEffort{}) << "a worker answers it";
}

TEST_F(Efforts, NothingIsToldOfOtherQuestionsOrOfARunThatIsStopped) {
    EXPECT_FALSE(effort());
    input_.query.question = Question::Distance;
    EXPECT_FALSE(effort([] { return true; }));
}

TEST_F(Efforts, NothingIsToldOfAMotionThatIsNone) {
    ask_for_motion(moved_pose({3, 0.5, 0}));
    scenario_.to.reset();
    EXPECT_FALSE(effort());
}

} // namespace
} // namespace cd::tests
