// Proves that motions of a run become bodies at rest at their event, with the contacts that the run
// says.
#include "client/folder/motion_case.hpp"

#include "common/job/answer_poses.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/motions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const BodyRadii radii{2, 2};

/// Motions of a box past, into and inside a larger one.
std::vector<Scenario> motions() {
    const std::array<std::pair<Vec3, Vec3>, 4> ways{{{Vec3(5, 0, 0), Vec3(5, 3, 0)},
                                                     {Vec3(5, 0.1, 0.2), Vec3(0.25, 0.1, 0.2)},
                                                     {Vec3(0, 0, 0), Vec3(0.01, 0, 0)},
                                                     {Vec3(1.6, 0, 0), Vec3(1.6, 4, 0)}}};
    std::vector<Scenario> scenarios;
    for (const auto& [from, to] : ways) {
        const auto keys = round_keys(std::array<PosePair, 2>{{{Pose(), moved_pose(from)},
                                                              {Pose(), moved_pose(to)}}},
                                     radii,
                                     0.01)
                              .value()
                              .keys;
        Scenario scenario;
        scenario.index = scenarios.size();
        scenario.poses = keys[0];
        scenario.to = keys[1];
        scenarios.push_back(scenario);
    }
    return scenarios;
}

/// A job of these motions.
PreparedJob job_of(Level level, std::optional<double> clearance) {
    PreparedJob job;
    job.meshes = {share(make_box({2, 2, 2})), share(make_box({1, 1, 1}))};
    job.query.level = level;
    job.query.clearance = clearance;
    job.query.question = Question::Motion;
    job.query.motion = MotionQuery{0.01, Until::Contact};
    return job;
}

/// Runs the motions of a job, and poses them at their answers.
CaseScenarios answers_of(const PreparedJob& job) {
    ThreadPool pool(1);
    const ObbTree a = build_tree(job.meshes[0], {}, pool);
    const ObbTree b = build_tree(job.meshes[1], {}, pool);
    const ScenarioRunner runner(a, b, job.query);
    CaseScenarios found;
    for (const Scenario& scenario : motions()) {
        found.results.push_back(runner.run(scenario).result);
        found.scenarios.push_back(at_answer(scenario, found.results.back()));
    }
    return found;
}

Status rest(PreparedJob& job, CaseScenarios& found) {
    TreeCache cache{std::filesystem::path()};
    ThreadPool pool(1);
    return rest_at_answers(job, found, cache, pool, {});
}

} // namespace

TEST(MotionCase, RestsAtTheEvent) {
    std::set<std::string> classes;
    for (const Level level : {Level::Any, Level::Pairs}) {
        for (const auto& clearance : {std::optional<double>(), std::optional(0.125)}) {
            PreparedJob job = job_of(level, clearance);
            CaseScenarios found = answers_of(job);
            const std::vector<ScenarioResult> of_motions = found.results;
            const Status rested = rest(job, found);
            ASSERT_TRUE(rested) << rested.error().detail;
            EXPECT_EQ(job.query.question, Question::Contacts);
            EXPECT_FALSE(job.query.motion);
            for (std::size_t i = 0; i < of_motions.size(); ++i) {
                classes.insert(std::string(to_text(of_motions[i].kind)));
                EXPECT_EQ(found.results[i].kind, of_motions[i].kind) << i;
                EXPECT_EQ(found.results[i].pairs, of_motions[i].pairs) << i;
                EXPECT_FALSE(found.results[i].motion);
                EXPECT_FALSE(found.scenarios[i].to);
            }
        }
    }
    EXPECT_THAT(classes, testing::IsSupersetOf({"separate", "inside", "contact", "near"}));
}

TEST(MotionCase, RefusesARunThatSaysOtherwise) {
    PreparedJob job = job_of(Level::Pairs, std::nullopt);
    CaseScenarios found = answers_of(job);
    found.results[1].pairs.pop_back();
    const Status rested = rest(job, found);
    ASSERT_FALSE(rested);
    EXPECT_THAT(rested.error().detail, HasSubstr("scenario 1 has other contacts here"));
}

TEST(MotionCase, LeavesWhatHasNoMotionAndWhatFailed) {
    PreparedJob job = job_of(Level::Pairs, std::nullopt);
    CaseScenarios found = answers_of(job);
    found.results[1].kind = ScenarioClass::Failed;
    found.results[1].failure = "lost";
    ASSERT_TRUE(rest(job, found));
    EXPECT_EQ(found.results[1].failure, "lost");
    const Bytes once = encode_result(found.results[2]);
    ASSERT_TRUE(rest(job, found));
    EXPECT_EQ(encode_result(found.results[2]), once);
}

} // namespace cd::tests
