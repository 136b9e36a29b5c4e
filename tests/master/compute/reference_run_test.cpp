// Proves that reference runs decide as a run of the whole job does, and that they can be stopped.
#include "master/compute/reference_run.hpp"

#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/support/packed_poses.hpp"

#include <gtest/gtest.h>

#include <latch>

namespace cd::tests {
namespace {

class ReferenceRun : public testing::Test {
  protected:
    ReferenceRun() {
        const auto tree = [&](const Mesh& mesh) {
            return std::make_shared<const ObbTree>(build_tree(share(mesh), {}, pool_));
        };
        material_ = std::make_shared<const JobMaterial>(
            JobMaterial{{tree(reference().a), tree(reference().b)}, {}, nullptr});
        poses_ = ordered(reference().scenarios);
    }

    asio::io_context context_;
    AsioLoop loop_{context_.get_executor()};
    ThreadPool pool_{1};
    Background background_{loop_, pool_, pool_, [] {}};
    std::shared_ptr<const JobMaterial> material_;
    std::shared_ptr<OrderedPoses> poses_;
};

TEST_F(ReferenceRun, GivesTheRecordOfAWholeRun) {
    ReferenceRuns runs(background_);
    const std::uint64_t scenario = scenario_with_contact();
    std::optional<ReferenceResult> found;
    runs.start(JobId{1}, scenario, material_, poses_, [&](Result<ReferenceResult> result) {
        found = std::move(result.value());
    });
    const auto work = asio::make_work_guard(context_);
    while (!found) {
        context_.run_one();
    }
    EXPECT_FALSE(found->is_stopped);
    const ResultRow& row = found->taken.results.rows().front();
    EXPECT_EQ(row.scenario, scenario);
    EXPECT_EQ(row.facts, facts_of(right_result(scenario)));
    EXPECT_FALSE(runs.stop(JobId{1}, std::nullopt)) << "none is left";
}

TEST_F(ReferenceRun, AStoppedRunIsACancelledFailure) {
    ReferenceRuns runs(background_);
    std::latch released(1);
    pool_.post([&] { released.wait(); });
    std::optional<ReferenceResult> found;
    runs.start(JobId{1}, 3, material_, poses_, [&](Result<ReferenceResult> result) {
        found = std::move(result.value());
    });
    EXPECT_FALSE(runs.stop(JobId{2}, std::nullopt));
    EXPECT_FALSE(runs.stop(JobId{1}, 4));
    EXPECT_TRUE(runs.stop(JobId{1}, 3));
    released.count_down();
    const auto work = asio::make_work_guard(context_);
    while (!found) {
        context_.run_one();
    }
    EXPECT_TRUE(found->is_stopped);
    EXPECT_EQ(found->taken.results.rows().front().facts.kind, ScenarioClass::Failed);
}

TEST_F(ReferenceRun, AfterTheCloseNothingIsReported) {
    std::latch released(1);
    {
        ReferenceRuns runs(background_);
        pool_.post([&] { released.wait(); });
        runs.start(JobId{1}, 3, material_, poses_, [](Result<ReferenceResult>) { FAIL(); });
        runs.close();
    }
    released.count_down();
    std::latch over(1);
    pool_.post([&] { over.count_down(); });
    over.wait();
    context_.run();
}

} // namespace
} // namespace cd::tests
