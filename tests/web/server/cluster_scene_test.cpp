// Proves what the page gets of a cluster's job of a scene: steps, bodies, poses in the world, and
// the next contact of one body.
#include "common/core/errors.hpp"
#include "tests/support/trees.hpp"
#include "web/server/cluster/cluster_jobs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::ElementsAre;

/// A job of three bodies of one mesh over two steps. Unless `is_scene`, it has no steps.
class SceneReader final : public ClusterReader {
  public:
    void status(Take<ClusterStatus> take) override { take(ClusterStatus()); }
    void map(const ContactMapQuery& /*query*/, Take<ContactMapAnswer> take) override {
        take(ContactMapAnswer());
    }
    [[nodiscard]] Result<RecordReader> records(JobId /*job*/,
                                               std::uint64_t /*scenarios*/) override {
        return none();
    }
    [[nodiscard]] Status may_run() override { return Done{}; }
    [[nodiscard]] Result<JobDescription> description(JobId /*job*/) override {
        JobDescription description;
        Submit& submit = description.submit;
        for (const char* const name : {"car.0", "car.1", "wall"}) {
            submit.bodies.push_back({.name = name});
        }
        submit.bodies[2].is_fixed = true;
        submit.scenarios = scenarios_.size();
        if (is_scene) {
            StepIndex steps;
            steps.add_step({2});
            steps.add_step({1});
            steps.set_times({0, 0.25});
            submit.poses.scene.emplace();
            submit.poses.scene->steps = pack_steps(steps);
        }
        return description;
    }
    [[nodiscard]] Result<LabelledScenarios> poses(JobId /*job*/,
                                                  const ScenarioChoice& choice) override {
        LabelledScenarios some;
        for (std::uint64_t i = 0; i < choice.size(); ++i) {
            some.scenarios.push_back(scenarios_[choice.at(i, scenarios_.size())]);
        }
        return some;
    }
    [[nodiscard]] Result<BodyTrees> trees(const Submit& /*submit*/) override {
        return BodyTrees(3, tree_);
    }
    [[nodiscard]] Result<std::shared_ptr<HttpBody>> mesh(const Sha256& /*mesh*/) override {
        return none();
    }

    bool is_scene = true;

  private:
    static Error none() { return {ErrorCode::NotFound, "there is none"}; }
    static PosePair at(double a, double b) {
        return {Pose::from_matrix(Mat3::Identity(), Vec3(a, 0, 0)),
                Pose::from_matrix(Mat3::Identity(), Vec3(b, 0, 0))};
    }
    std::shared_ptr<const ObbTree> tree_ =
        std::make_shared<const ObbTree>(make_tree(make_box({1, 2, 3})));
    std::vector<Scenario> scenarios_{
        {0, 0, 1, at(1, 2), 0}, {1, 0, 2, at(1, 9), 0}, {2, 1, 2, at(3, 9), 1}};
};

class SceneOfCluster : public testing::Test {
  protected:
    SceneOfCluster() { job_.status.summary.total = 3; }

    /// All three scenarios are in contact.
    static RecordReader records() {
        return [](const ScenarioChoice& choice, const auto& take) -> Status {
            constexpr std::array<std::array<std::uint32_t, 2>, 3> bodies{{{0, 1}, {0, 2}, {1, 2}}};
            for (std::uint64_t i = choice.first; i < choice.first + choice.count; ++i) {
                ScenarioResult result;
                result.index = i;
                result.body_a = bodies[i][0];
                result.body_b = bodies[i][1];
                result.kind = ScenarioClass::Cross;
                CD_TRY(take(i, result));
            }
            return Done{};
        };
    }
    Result<NextFound> next(std::uint64_t from, bool is_backwards, const std::string& body) {
        NextContact wanted{from, is_backwards};
        wanted.body = body;
        return next_of(reader_, records(), job_, wanted);
    }

    SceneReader reader_;
    PagedJob job_;
};

} // namespace

TEST_F(SceneOfCluster, ScenariosHaveStepsAndBodies) {
    EXPECT_THAT(places_of(reader_, job_, {1, 2}).value(),
                ElementsAre(ScenePlace{0, 0, 2}, ScenePlace{1, 1, 2}));
    EXPECT_THAT(steps_of(reader_, job_, {0, 2}).value(),
                ElementsAre(StepRow{0, 0}, StepRow{2, 0.25}));
    EXPECT_EQ(places_of(reader_, job_, {1, 3}).error().code, ErrorCode::BadInput);
}

TEST_F(SceneOfCluster, PosesAreThoseOfBothBodiesInTheWorld) {
    const PoseRows rows = poses_of(reader_, job_, {2, 1}).value();
    EXPECT_EQ(rows.poses_each, 2u);
    ASSERT_EQ(rows.numbers.size(), 24u);
    EXPECT_EQ(rows.numbers[3], 3);
    EXPECT_EQ(rows.numbers[15], 9);
}

TEST_F(SceneOfCluster, OnlyMotionsHaveKeys) {
    EXPECT_EQ(motions_of(reader_, job_, {0, 1}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(motions_of(reader_, job_, {2, 2}).error().code, ErrorCode::BadInput);
}

TEST_F(SceneOfCluster, TheDescriptionHasStepsBoxesAndWhatIsFixed) {
    const JobView view = view_of(reader_, job_, {}).value();
    EXPECT_EQ(view.steps, 2u);
    EXPECT_TRUE(view.poses.of_both_bodies);
    EXPECT_EQ(view.bodies[1].low, Vec3(-0.5, -1, -1.5));
    EXPECT_EQ(view.bodies[1].size, Vec3(1, 2, 3));
    EXPECT_TRUE(view.bodies[2].body.is_fixed);
}

TEST_F(SceneOfCluster, TheNextContactIsOfTheWantedBody) {
    EXPECT_EQ(next(0, false, "").value().scenario, 1u);
    EXPECT_EQ(next(0, false, "car.1").value().scenario, 2u);
    EXPECT_EQ(next(0, false, "2").value().scenario, 1u);
    EXPECT_EQ(next(2, true, "car.1").value().scenario, 0u);
    EXPECT_EQ(next(1, false, "car.0").value().scenario, std::nullopt);
    EXPECT_EQ(next(0, false, "lorry").error().code, ErrorCode::BadInput);
}

TEST_F(SceneOfCluster, AJobWithoutStepsHasNoSuchArrays) {
    reader_.is_scene = false;
    EXPECT_EQ(places_of(reader_, job_, {0, 1}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(steps_of(reader_, job_, {0, 1}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(view_of(reader_, job_, {}).value().steps, std::nullopt);
}

} // namespace cd::tests
