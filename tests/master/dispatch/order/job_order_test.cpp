// Proves whose work goes out first: by priority, then equal thread time for owners, then for the
// jobs of one owner.
#include "master/dispatch/order/job_order.hpp"

#include "common/core/timing/master.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace cd::tests {
namespace {

constexpr JobId a{1};
constexpr JobId b{2};
constexpr JobId c{3};
constexpr std::uint64_t second = 1'000'000'000;

class Ordering : public testing::Test {
  protected:
    void open(JobId job, const std::string& owner, std::int32_t priority = 0) {
        order_.open(job, {priority, owner});
        jobs_.push_back(job);
    }
    void close(JobId job) {
        order_.close(job);
        std::erase(jobs_, job);
    }
    /// Sends and answers a task; its measured time is `factor` times the predicted one.
    void run(JobId job, std::uint64_t predicted_ns, double factor = 1) {
        order_.sent(job, predicted_ns);
        order_.left(job, predicted_ns);
        const double seconds = factor * 1e-9 * static_cast<double>(predicted_ns);
        order_.answered(job, predicted_ns, seconds, now_ += 1e-3);
        had_[job] += seconds;
    }
    [[nodiscard]] JobId first() const {
        JobId first = jobs_.front();
        for (const JobId job : jobs_) {
            first = job != first && order_.comes_before(job, first) ? job : first;
        }
        return first;
    }
    /// Lets the first job have a task, again and again; `costs_ns`: cost of a task of each.
    void serve(int tasks, const std::map<JobId, std::uint64_t>& costs_ns, double factor = 1) {
        for (int i = 0; i < tasks; ++i) {
            const JobId job = first();
            run(job, costs_ns.at(job), factor);
        }
    }

    JobOrder order_;
    std::vector<JobId> jobs_;
    std::map<JobId, double> had_; ///< Thread time, s.
    double now_ = 0;
};

TEST_F(Ordering, TheHighestPriorityIsFirstWhateverItHasHad) {
    open(a, "ann");
    open(b, "bob", 5);
    open(c, "bob", -5);
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(first(), b);
        run(b, 100 * second);
    }
    EXPECT_TRUE(order_.comes_before(a, c));
    close(b);
    EXPECT_EQ(first(), a);
    run(a, 1000 * second);
    EXPECT_EQ(first(), a);
}

TEST_F(Ordering, ANewPriorityCountsAtOnceAndLevelWithItsNewNeighbours) {
    open(a, "ann");
    open(b, "bob", 5);
    open(c, "bob", 5);
    run(a, 100 * second);
    serve(20, {{b, second}, {c, second}});
    order_.set_priority(a, 5);
    had_.clear();
    serve(200, {{a, second}, {b, second}, {c, second}});
    EXPECT_NEAR(had_[a], 100, 2) << "as much as bob, who owes for his 20 s as little";
    EXPECT_NEAR(had_[b], 50, 2);
    order_.set_priority(b, 6);
    EXPECT_EQ(first(), b);
    order_.set_priority(b, -1);
    EXPECT_TRUE(order_.comes_before(c, b));
    close(a);
    close(c);
    EXPECT_EQ(first(), b);
}

TEST_F(Ordering, WorkInFlightGoesAlongToTheNewPriority) {
    open(a, "ann");
    open(b, "bob");
    order_.sent(a, 10 * second);
    order_.set_priority(a, 5);
    open(c, "bob", 5);
    EXPECT_EQ(first(), a) << "c starts level, with what a has in flight";
    order_.left(a, 10 * second); // Lost: a has had nothing.
    EXPECT_EQ(order_.in_flight_ns(a), 0u);
    had_.clear();
    serve(200, {{a, second}, {c, second}});
    EXPECT_NEAR(had_[a] - had_[c], 10, 2);
    order_.set_priority(a, 0);
    order_.set_priority(a, 0);
    EXPECT_TRUE(order_.comes_before(a, b)) << "level again, and ann is before bob";
}

TEST_F(Ordering, OwnersOfUnlikeNumbersOfJobsAndUnlikeCostsGetTheSame) {
    order_.set_threads(100);
    open(a, "ann");
    open(b, "bob");
    open(c, "bob");
    open(JobId{4}, "bob");
    serve(4000, {{a, second / 10}, {b, second}, {c, second / 7}, {JobId{4}, second / 100}});
    const double of_bob = had_[b] + had_[c] + had_[JobId{4}];
    EXPECT_NEAR(had_[a] / of_bob, 1, 0.05);
    EXPECT_NEAR(had_[b] / of_bob, 1. / 3, 0.02);
    EXPECT_NEAR(had_[c] / of_bob, 1. / 3, 0.02);
}

TEST_F(Ordering, TheMeasuredTimeCountsAndNotThePredictedOne) {
    open(a, "ann");
    open(b, "bob");
    for (int i = 0; i < 1000; ++i) {
        const JobId job = first();
        run(job, second / 100, job == a ? 20 : 1);
    }
    EXPECT_NEAR(had_[a] / had_[b], 1, 0.05);
}

TEST_F(Ordering, WorkInFlightCountsAsPredictedAndLeavesWithoutATrace) {
    open(a, "ann");
    open(b, "bob");
    order_.sent(a, second);
    EXPECT_EQ(order_.in_flight_ns(a), second);
    EXPECT_EQ(first(), b);
    order_.left(a, second); // Lost with its worker.
    EXPECT_EQ(order_.in_flight_ns(a), 0u);
    EXPECT_EQ(first(), a);
    order_.sent(b, second);
    order_.left(b, second);
    order_.answered(b, second, 0, 1); // Not measured: it took as long as predicted.
    EXPECT_EQ(first(), a);
}

TEST_F(Ordering, WhoComesLaterOwesNothingAndHasSavedNothing) {
    open(a, "ann");
    run(a, 500 * second);
    open(b, "bob");
    serve(200, {{a, second}, {b, second}});
    EXPECT_NEAR(had_[b], 100, 2);
    open(c, "bob"); // Level with its sibling.
    had_.clear();
    serve(400, {{a, second}, {b, second}, {c, second}});
    EXPECT_NEAR(had_[a], 200, 2);
    EXPECT_NEAR(had_[c], 100, 2);
}

TEST_F(Ordering, AnOwnerWithoutWorkSavesUpSomeSecondsOfAllThreads) {
    order_.set_threads(10);
    open(a, "ann");
    open(b, "bob");
    for (int i = 0; i < 1000; ++i) {
        run(a, second); // Nothing of b is there to be sent.
    }
    EXPECT_EQ(first(), b);
    had_.clear();
    serve(200, {{a, second}, {b, second}});
    EXPECT_NEAR(had_[b] - had_[a], timing::share_credit_seconds * 10, 2);
}

TEST_F(Ordering, TheShareIsOfTheLastSeconds) {
    open(a, "ann");
    open(b, "bob");
    EXPECT_EQ(order_.share(a, 0), 0);
    for (int i = 0; i < 300; ++i) {
        run(a, 3 * second);
        run(b, second);
        now_ += 1;
    }
    EXPECT_NEAR(order_.share(a, now_), 0.75, 0.02);
    EXPECT_NEAR(order_.share(b, now_), 0.25, 0.02);
    for (int i = 0; i < 60; ++i) {
        run(b, second);
        now_ += 1;
    }
    EXPECT_LT(order_.share(a, now_), 0.02);
    close(b);
    EXPECT_EQ(order_.share(b, now_), 0);
    EXPECT_EQ(order_.share(a, now_), 1);
}

TEST_F(Ordering, WorkOfAClosedJobIsIgnored) {
    open(a, "ann");
    order_.sent(a, second);
    close(a);
    order_.sent(a, 1);
    order_.left(a, second);
    order_.answered(a, second, 1, 1);
    open(b, "ann");
    EXPECT_EQ(order_.in_flight_ns(b), 0u);
}

TEST_F(Ordering, IsStrictAndTheSameEachTime) {
    open(a, "ann");
    open(b, "bob");
    open(c, "ann");
    for (const JobId one : {a, b, c}) {
        for (const JobId other : {a, b, c}) {
            EXPECT_EQ(order_.comes_before(one, other) + order_.comes_before(other, one),
                      one == other ? 0 : 1);
        }
    }
    EXPECT_EQ(first(), a);
}

} // namespace
} // namespace cd::tests
