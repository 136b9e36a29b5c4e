// Proves that a run in one process gives every result once, in order, with one digest for any
// number of threads, and that it stops promptly on request.
#include "client/local/local_run.hpp"

#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

constexpr std::uint64_t scenarios = 3000;

class LocalRun : public testing::Test {
  protected:
    static std::vector<Scenario> make_scenarios() {
        std::mt19937_64 random(7);
        std::vector<Scenario> list(scenarios);
        for (std::uint64_t i = 0; i < scenarios; ++i) {
            list[i].index = i;
            list[i].poses.b = make_pose(random, 2.5);
        }
        return list;
    }

    [[nodiscard]] Result<RunOutcome> run(unsigned threads, RunObserver observer) {
        ThreadPool pool(threads);
        const auto poses = make_list_source(make_scenarios());
        if (!observer.results) {
            observer.results = [](const DoneBlock&) { return Status(Done{}); };
        }
        if (!observer.progress) {
            observer.progress = [](const Summary&, double) {};
        }
        if (!observer.stopped) {
            observer.stopped = [] { return false; };
        }
        return run_locally({a_, b_}, *poses, query_, pool, observer, options_);
    }

    ThreadPool build_pool_{1};
    ObbTree a_ = build_tree(share(make_torus(1.0, 0.4, 24, 12)), {}, build_pool_);
    ObbTree b_ = build_tree(share(make_sphere(2)), {}, build_pool_);
    Query query_;
    LocalRunOptions options_;
};

} // namespace

TEST_F(LocalRun, EveryResultComesOnceInOrder) {
    std::uint64_t next = 0;
    std::uint64_t contacts = 0;
    const auto list = make_scenarios();
    const auto check = [&](const DoneScenario& done) {
        const ScenarioResult& result = done.result;
        EXPECT_EQ(result.index, next);
        EXPECT_EQ(done.record, encode_result(result));
        EXPECT_EQ(done.digest, digest_of(run_scenario(a_, b_, list[next], query_).result));
        ++next;
        contacts += result.pair_count == 0 ? 0 : 1;
        return Status(Done{});
    };
    const auto outcome =
        run(3, {[&](const DoneBlock& results) { return results.for_each(check); }, {}, {}});
    ASSERT_TRUE(outcome) << outcome.error().detail;
    EXPECT_EQ(next, scenarios);
    EXPECT_TRUE(outcome.value().summary.is_complete());
    EXPECT_EQ(outcome.value().summary.total, scenarios);
    // Both outcomes occurred.
    EXPECT_GT(contacts, scenarios / 10);
    EXPECT_LT(contacts, scenarios * 9 / 10);
}

TEST_F(LocalRun, TheDigestDoesNotDependOnThreads) {
    for (const Level level : {Level::Any, Level::Count, Level::Contacts}) {
        query_.level = level;
        const auto one = run(1, {});
        const auto three = run(3, {});
        ASSERT_TRUE(one);
        ASSERT_TRUE(three);
        ASSERT_TRUE(one.value().digest);
        EXPECT_EQ(one.value().digest, three.value().digest);
    }
}

TEST_F(LocalRun, TheDigestDoesNotDependOnSupportPoints) {
    const ObbTree boxes_a = a_;
    const ObbTree boxes_b = b_;
    for (const Level level : {Level::Any, Level::Pairs}) {
        query_.level = level;
        a_ = boxes_a;
        b_ = boxes_b;
        const auto boxes = run(2, {});
        a_.prepare_planes();
        b_.prepare_planes();
        const auto planes = run(2, {});
        ASSERT_TRUE(boxes);
        ASSERT_TRUE(planes);
        EXPECT_EQ(boxes.value().digest, planes.value().digest);
        EXPECT_LT(planes.value().statistics.search.box_tests,
                  boxes.value().statistics.search.box_tests);
    }
}

TEST_F(LocalRun, StatisticsAreTheSumsOverAllScenarios) {
    // (Level any is excluded: its pairs depend on the order, since a search tries earlier contacts
    // first.)
    for (const Level level : {Level::Count, Level::Pairs}) {
        query_.level = level;
        QueryStatistics expected;
        for (const Scenario& scenario : make_scenarios()) {
            expected += run_scenario(a_, b_, scenario, query_).statistics;
        }
        const auto outcome = run(3, {});
        ASSERT_TRUE(outcome);
        const QueryStatistics& found = outcome.value().statistics.search;
        EXPECT_EQ(found.box_tests, expected.box_tests);
        EXPECT_EQ(found.triangle_tests, expected.triangle_tests);
        EXPECT_GT(found.triangle_tests, 0u);
        ASSERT_TRUE(outcome.value().cost);
        EXPECT_GT(outcome.value().cost->seconds_of(found), 0);
    }
}

TEST_F(LocalRun, AnInterruptEndsIt) {
    std::uint64_t seen = 0;
    const auto outcome = run(2,
                             {[&](const DoneBlock&) {
                                  ++seen;
                                  return Status(Done{});
                              },
                              {},
                              [&] { return seen >= 2; }});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(seen, 2u);
}

TEST_F(LocalRun, AWriterThatFailsEndsIt) {
    const auto outcome = run(2,
                             {[](const DoneBlock& results) {
                                  return results.first() + results.size() > 5
                                             ? Status(Error{ErrorCode::Io, "disk full"})
                                             : Status(Done{});
                              },
                              {},
                              {}});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().detail, "disk full");
}

TEST_F(LocalRun, PosesThatCannotBeReadEndIt) {
    class Broken final : public PoseSource {
      public:
        std::uint64_t count() const override { return 1000; }
        Result<std::vector<Scenario>> read(std::uint64_t first, std::uint64_t) override {
            if (first >= 128) {
                return Error{ErrorCode::BadInput, "row 128"};
            }
            std::vector<Scenario> list(1);
            list[0].index = first;
            return list;
        }
    };
    Broken poses;
    ThreadPool pool(2);
    const auto outcome = run_locally({a_, b_},
                                     poses,
                                     query_,
                                     pool,
                                     {[](const DoneBlock&) { return Status(Done{}); },
                                      [](const Summary&, double) {},
                                      [] { return false; }});
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().detail, "row 128");
}

} // namespace cd::tests
