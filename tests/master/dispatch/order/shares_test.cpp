// Proves in simulated time, with the real dispatcher, how jobs share the workers' threads: owners
// alike, whatever their jobs are and cost, and the jobs of an owner alike; that a job of higher
// priority overtakes; and that no job of equal priority starves.
#include "master/dispatch/dispatcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

struct SharedJob {
    JobRank rank;
    double seconds = 0.01; ///< Mean time of a scenario on a thread.
    bool is_analysed = true;
    double predicted = 1; ///< Predicted time by actual time.
    std::uint64_t scenarios = 1u << 30;
};

/// Workers that compute in the order of their tasks, and jobs that always have enough analysed
/// scenarios or positions at the dispatcher until they are through.
class SharedCluster {
  public:
    explicit SharedCluster(const std::vector<std::uint32_t>& threads) {
        for (const std::uint32_t count : threads) {
            const WorkerId id{workers_.size() + 1};
            workers_[id].idle = count;
            act(dispatcher_.worker_joined(id, {"w", count}));
        }
    }

    JobId open(const SharedJob& job) {
        const JobId id{jobs_.size() + 1};
        jobs_[id].job = job;
        act(dispatcher_.job_opened(
            id, {}, {{TreeId{1}, {100, 100}, {6400, 6400}}, {TreeId{2}, {1}, {64}}}, job.rank));
        feed();
        return id;
    }

    /// Runs until this time, s.
    void run_until(double end) {
        while (!ends_.empty() && ends_.top().time <= end) {
            const Event event = ends_.top();
            ends_.pop();
            now_ = event.time;
            dispatcher_.time_is(now_);
            finish(event);
            feed();
        }
        now_ = end;
        dispatcher_.time_is(now_);
    }

    /// Thread time of the job's answers so far, s.
    [[nodiscard]] double had(JobId job) const { return jobs_.at(job).had; }
    [[nodiscard]] bool is_over(JobId job) const {
        return jobs_.at(job).answered == jobs_.at(job).job.scenarios;
    }
    [[nodiscard]] const Dispatcher& dispatcher() const { return dispatcher_; }

  private:
    struct Job {
        SharedJob job;
        std::uint64_t fed = 0;
        std::uint64_t answered = 0;
        double had = 0;
    };
    struct Item {
        TaskId task;
        JobId job;
        std::uint64_t position = 0;
    };
    struct Worker {
        std::uint32_t idle = 0; ///< Threads.
        std::deque<Item> queue;
        std::map<TaskId, std::uint64_t> left;
    };
    struct Event {
        double time = 0;
        std::uint64_t number = 0;
        WorkerId worker;
        Item item;
        double seconds = 0;

        bool operator<(const Event& other) const {
            return std::pair(time, number) > std::pair(other.time, other.number);
        }
    };

    /// Half to one and a half of the job's mean, always the same for a scenario.
    [[nodiscard]] double seconds_of(JobId id, std::uint64_t position) const {
        std::mt19937_64 random(id.value * 1'000'003 + position);
        return jobs_.at(id).job.seconds * (0.5 + static_cast<double>(random() % 1000) / 1000);
    }

    void feed() {
        bool any = true;
        for (int round = 0; any && round < 10'000; ++round) {
            any = false;
            for (auto& [id, job] : jobs_) {
                any = feed_one(id, job) || any;
            }
        }
        act(dispatcher_.input_paused());
    }
    bool feed_one(JobId id, Job& job) {
        if (job.fed == job.job.scenarios) {
            return false;
        }
        if (!job.job.is_analysed) {
            const std::uint64_t count =
                std::min<std::uint64_t>(10'000, job.job.scenarios - job.fed);
            if (dispatcher_.positions_unsent(id) >= dispatcher_.positions_enough(id)) {
                return false;
            }
            const std::uint64_t first = std::exchange(job.fed, job.fed + count);
            act(dispatcher_.positions_given(
                id, {{first, count}}, job.job.scenarios - first - count));
            return true;
        }
        if (unsent_[id] >= dispatcher_.unsent_enough() / jobs_.size()) { // As `WorkFeed` has it.
            return false;
        }
        const double predicted_ns = 1e9 * job.job.predicted * seconds_of(id, job.fed);
        ++unsent_[id];
        act(dispatcher_.scenario_analysed(
            id, {job.fed++, {0}, {0}, 100, static_cast<std::uint64_t>(predicted_ns)}));
        return true;
    }

    void act(const Actions& actions) {
        for (const Action& action : actions) {
            const auto* sent = std::get_if<SendUnit>(&action);
            if (sent == nullptr) {
                continue;
            }
            Worker& worker = workers_.at(sent->worker);
            worker.left[sent->task] = sent->positions.count();
            unsent_[sent->job] -= sent->is_analysed ? sent->positions.count() : 0;
            for (const std::uint64_t position : sent->positions.list()) {
                worker.queue.push_back({sent->task, sent->job, position});
            }
            work(sent->worker, worker);
        }
    }
    void work(WorkerId id, Worker& worker) {
        for (; worker.idle != 0 && !worker.queue.empty(); --worker.idle) {
            const Item item = worker.queue.front();
            worker.queue.pop_front();
            const double seconds = seconds_of(item.job, item.position);
            ends_.push({now_ + seconds, ++events_, id, item, seconds});
        }
    }
    void finish(const Event& event) {
        Worker& worker = workers_.at(event.worker);
        Job& job = jobs_.at(event.item.job);
        job.had += event.seconds;
        ++job.answered;
        ++worker.idle;
        work(event.worker, worker);
        const TaskId task = event.item.task;
        act(dispatcher_.answered({event.worker,
                                  task,
                                  event.item.job,
                                  PositionRange{event.item.position, 1},
                                  event.seconds}));
        if (--worker.left.at(task) == 0) {
            worker.left.erase(task);
            act(dispatcher_.task_ended(event.worker, task));
        }
        if (job.answered == job.job.scenarios) {
            act(dispatcher_.job_closed(event.item.job));
        }
    }

    Dispatcher dispatcher_;
    std::map<JobId, Job> jobs_;
    std::map<JobId, std::uint64_t> unsent_; ///< Analysed scenarios in no task.
    std::map<WorkerId, Worker> workers_;
    std::priority_queue<Event> ends_;
    std::uint64_t events_ = 0;
    double now_ = 0;
};

TEST(Shares, OwnersGetTheSameWhateverTheirJobsCost) {
    SharedCluster cluster({4, 4, 8, 2});
    std::map<std::string, std::vector<JobId>> jobs;
    const auto open = [&](const std::string& owner, double seconds, bool is_analysed, double by) {
        jobs[owner].push_back(cluster.open({{0, owner}, seconds, is_analysed, by}));
    };
    open("ann", 0.03, true, 1);
    for (const double seconds : {0.006, 0.03, 0.09, 0.24}) {
        open("bob", seconds, true, 1);
    }
    open("eve", 0.015, true, 0.1); // Predicted to be ten times as short as it is.
    open("eve", 0.003, false, 1);
    cluster.run_until(10);
    std::map<JobId, double> before;
    for (const auto& [owner, list] : jobs) {
        for (const JobId job : list) {
            before[job] = cluster.had(job);
        }
    }
    cluster.run_until(130);
    const double all = 120 * 18; // Thread time.
    for (const auto& [owner, list] : jobs) {
        double had = 0;
        double shown = 0;
        for (const JobId job : list) {
            const double of_job = cluster.had(job) - before[job];
            const auto alike = static_cast<double>(3 * list.size());
            EXPECT_NEAR(of_job * alike / all, 1, 0.1) << owner << " job " << job.value;
            had += of_job;
            shown += cluster.dispatcher().share(job);
        }
        EXPECT_NEAR(3 * had / all, 1, 0.05) << owner;
        EXPECT_NEAR(shown, 1. / 3, 0.03) << owner;
    }
}

TEST(Shares, AHigherPriorityOvertakesAndTheOthersGoOnAfterIt) {
    for (const bool is_analysed : {true, false}) {
        SharedCluster cluster({4, 8});
        const JobId low = cluster.open({{0, ""}, 0.01, is_analysed});
        const JobId lowest = cluster.open({{-10, ""}, 0.01, !is_analysed});
        cluster.run_until(10);
        EXPECT_NEAR(cluster.had(low), 10 * 12, 2);
        EXPECT_LT(cluster.had(lowest), 1);
        const JobId high = cluster.open({{10, ""}, 0.01, is_analysed, 1, 6000}); // 60 s of threads.
        cluster.run_until(11);
        const double low_before = cluster.had(low);
        cluster.run_until(13);
        EXPECT_LT(cluster.had(low) - low_before, 1);
        EXPECT_NEAR(cluster.had(high), 3 * 12, 6);
        cluster.run_until(17);
        EXPECT_TRUE(cluster.is_over(high));
        EXPECT_GT(cluster.had(low) - low_before, 10);
    }
}

TEST(Shares, NoJobOfEqualPriorityStarves) {
    SharedCluster cluster({2, 6});
    std::vector<JobId> jobs;
    for (int i = 0; i < 24; ++i) {
        const std::string owner = i < 2 ? "ann" : "bob";
        jobs.push_back(
            cluster.open({{2, owner}, i % 3 == 0 ? 0.05 : 0.01, i % 2 == 0, i % 5 == 0 ? 3. : 1.}));
    }
    cluster.run_until(20);
    for (double end = 220; end <= 420; end += 200) { // A turn of all jobs takes some 20 s.
        std::map<JobId, double> before;
        for (const JobId job : jobs) {
            before[job] = cluster.had(job);
        }
        cluster.run_until(end);
        for (std::size_t i = 0; i < jobs.size(); ++i) {
            const double fair = i < 2 ? 1600. / 2 / 2 : 1600. / 2 / 22;
            EXPECT_GT(cluster.had(jobs[i]) - before[jobs[i]], 0.5 * fair) << i << " at " << end;
        }
    }
}

TEST(Shares, WhatOneOwnerCannotUseTheOthersGet) {
    SharedCluster cluster({4});
    const JobId ann = cluster.open({{0, "ann"}, 0.01, true});
    const JobId bob = cluster.open({{0, "bob"}, 0.01, true, 1, 200}); // 2 s of threads.
    cluster.run_until(10);
    EXPECT_TRUE(cluster.is_over(bob));
    EXPECT_NEAR(cluster.had(ann) + cluster.had(bob), 10 * 4, 1);
}

} // namespace
} // namespace cd::tests
