// Proves how a job ends: unbegun scenarios move to idle workers; begun or unreturned ones get a
// speculative copy if it ends clearly sooner, for a bounded share of the work; the first answer
// counts, and the other worker is told to stop. Runs on a simulated clock, with workers that
// process their tasks in order.
#include "common/core/limits/master.hpp"
#include "master/dispatch/dispatcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <random>
#include <set>

namespace cd::tests {
namespace {

constexpr JobId job{1};
constexpr double second_ns = 1e9;

enum class Way { Scenarios, Places };

struct Host {
    double speed = 1;
    double stops_at = 1e9; ///< The host does and answers nothing from then on.
};

/// Workers of one thread each.
class EndRun {
  public:
    EndRun(Way way, std::vector<Host> hosts) : way_(way), hosts_(std::move(hosts)) {}

    bool helps = true; ///< False: workers return nothing and drop copies.

    /// Returns the seconds until the last answer.
    double run(const std::vector<double>& seconds) {
        seconds_ = seconds;
        answers_.assign(seconds.size(), 0);
        for (std::size_t i = 0; i < hosts_.size(); ++i) {
            act(dispatcher_.worker_joined(WorkerId{i + 1}, {"w", 1}));
        }
        ClusterOptions options;
        options.strategy = way_ == Way::Places ? "best-match" : "earliest-finish";
        act(dispatcher_.job_opened(job, options, {{TreeId{1}, {1}, {}}, {TreeId{2}, {1}, {}}}));
        if (way_ == Way::Places) {
            act(dispatcher_.positions_given(job, {{0, seconds.size()}}, 0));
        }
        for (std::uint64_t i = 0; i < seconds.size() && way_ == Way::Scenarios; ++i) {
            const auto predicted = static_cast<std::uint64_t>(second_ns * seconds[i]);
            act(dispatcher_.scenario_analysed(job, {i, {0}, {0}, 100, predicted}));
        }
        act(dispatcher_.input_paused());
        while (answered_ != seconds.size() && step()) {
        }
        EXPECT_EQ(answered_, seconds.size());
        return now_;
    }

    std::uint64_t begun_twice = 0;
    std::uint64_t recalled = 0;
    std::uint64_t copied = 0;
    double copied_seconds = 0;

  private:
    struct Item {
        TaskId task;
        std::uint64_t scenario = 0;
    };
    struct Worker {
        std::deque<Item> queue; ///< The first item has begun.
        double ends = 0;        ///< When the first item ends.
    };

    [[nodiscard]] bool has_stopped(std::size_t host) const { return now_ >= hosts_[host].stops_at; }

    void begin_next(std::size_t host) {
        Worker& worker = workers_[host];
        if (!worker.queue.empty()) {
            const std::uint64_t scenario = worker.queue.front().scenario;
            begun_twice += begun_.insert(scenario).second ? 0 : 1;
            worker.ends = now_ + seconds_[scenario] / hosts_[host].speed;
        }
    }

    /// Advances to the next end of a scenario or clock tick.
    bool step() {
        std::size_t next = hosts_.size();
        for (std::size_t i = 0; i < hosts_.size(); ++i) {
            if (!workers_[i].queue.empty() && workers_[i].ends < hosts_[i].stops_at &&
                (next == hosts_.size() || workers_[i].ends < workers_[next].ends)) {
                next = i;
            }
        }
        looked_ += 0.1;
        if (next == hosts_.size() || workers_[next].ends > looked_) {
            now_ = std::max(now_, looked_);
            dispatcher_.time_is(now_);
            act(dispatcher_.input_paused());
            return now_ < 1000;
        }
        looked_ -= 0.1;
        now_ = workers_[next].ends;
        dispatcher_.time_is(now_);
        finish_first(next);
        return true;
    }

    void finish_first(std::size_t host) {
        Worker& worker = workers_[host];
        const Item item = worker.queue.front();
        worker.queue.pop_front();
        begin_next(host);
        const WorkerId id{host + 1};
        answered_ += ++answers_[item.scenario] == 1 ? 1 : 0;
        const double took = seconds_[item.scenario] / hosts_[host].speed;
        act(dispatcher_.answered({id, item.task, job, PositionRange{item.scenario, 1}, took}));
        end_if_done(host, item.task);
        act(dispatcher_.input_paused());
    }

    void end_if_done(std::size_t host, TaskId task) {
        const auto& queue = workers_[host].queue;
        if (std::ranges::none_of(queue, [&](const Item& item) { return item.task == task; })) {
            act(dispatcher_.task_ended(WorkerId{host + 1}, task));
        }
    }

    void act(const Actions& actions) {
        dispatcher_.check_invariants();
        for (const Action& action : actions) {
            std::visit([this](const auto& one) { perform(one); }, action);
        }
    }

    void add(WorkerId worker, TaskId task, std::uint64_t scenario) {
        Worker& content = workers_[worker.value - 1];
        content.queue.push_back({task, scenario});
        if (content.queue.size() == 1) {
            begin_next(worker.value - 1);
        }
    }
    void count_copy(std::uint64_t scenario) {
        ++copied;
        copied_seconds += seconds_[scenario];
    }

    void perform(const SendUnit& unit) {
        const bool is_copy = unit.copy_of != TaskId{};
        for (const std::uint64_t position : unit.positions.list()) {
            if (is_copy) {
                count_copy(position);
            }
            if (helps || !is_copy) {
                add(unit.worker, unit.task, position);
            }
        }
    }
    void perform(const GiveUp& /*action*/) { ADD_FAILURE() << "nothing is lost here"; }
    void perform(const PositionsLost& /*lost*/) { ADD_FAILURE() << "nothing is lost here"; }

    /// The first of the queue has begun, so it is not returned.
    void perform(const AskBack& ask) {
        const std::size_t host = ask.worker.value - 1;
        if (!helps || has_stopped(host)) {
            return;
        }
        std::deque<Item>& queue = workers_[host].queue;
        PositionSet returned;
        for (auto item = queue.begin() + (queue.empty() ? 0 : 1); item != queue.end();) {
            const bool is_asked = way_ == Way::Places
                                      ? item->scenario >= ask.positions.runs().front().first
                                      : ask.positions.contains(item->scenario);
            if (item->task != ask.task || !is_asked) {
                ++item;
                continue;
            }
            returned.add({item->scenario, 1});
            item = queue.erase(item);
        }
        act(dispatcher_.task_recalled(ask.worker, ask.task, returned));
        end_if_done(host, ask.task);
    }
    void perform(const UnitsReturned& returned) { recalled += returned.positions; }
    void perform(const SendHint& /*hint*/) {} // A hint only serves the cache.
    void perform(const CallOff& loser) {
        const std::size_t host = loser.worker.value - 1;
        if (has_stopped(host)) {
            return;
        }
        std::deque<Item>& queue = workers_[host].queue;
        const auto is_dropped = [&](const Item& item) {
            return item.task == loser.task && loser.positions.contains(item.scenario);
        };
        const bool was_first = !queue.empty() && is_dropped(queue.front());
        if (std::erase_if(queue, is_dropped) != 0) {
            if (was_first) {
                begin_next(host);
            }
            end_if_done(host, loser.task);
        }
    }

    Way way_;
    std::vector<Host> hosts_;
    std::vector<double> seconds_; ///< Duration of each scenario at speed 1.
    Dispatcher dispatcher_;
    double now_ = 0;
    double looked_ = 0;
    std::map<std::size_t, Worker> workers_;
    std::set<std::uint64_t> begun_;
    std::vector<int> answers_;
    std::uint64_t answered_ = 0;
};

class AtTheEnd : public testing::TestWithParam<Way> {
  protected:
    static std::vector<double> like(std::size_t count, double seconds) {
        return std::vector<double>(count, seconds);
    }
};

TEST_P(AtTheEnd, UnbegunScenariosMoveToIdleWorkers) {
    // The slow worker gets as much as the others before anything is measured.
    const auto scenarios = like(60, 0.01);
    EndRun helped(GetParam(), {{1}, {1}, {0.02}});
    EndRun alone(GetParam(), {{1}, {1}, {0.02}});
    alone.helps = false;
    const double seconds = helped.run(scenarios);
    EXPECT_GT(helped.recalled, 3u);
    EXPECT_LT(seconds, 0.7);
    EXPECT_GT(alone.run(scenarios), 2 * seconds);
    EXPECT_LE(helped.begun_twice, helped.copied) << "what is recalled is done once";
}

TEST_P(AtTheEnd, BegunScenariosAreCopiedIfThatEndsSooner) {
    // 5 % of 200 scenarios are 10.
    const auto scenarios = like(200, 0.1);
    EndRun helped(GetParam(), {{1}, {1}, {1, 2.05}});
    const double seconds = helped.run(scenarios);
    EXPECT_GT(helped.copied, 0u);
    EXPECT_LT(seconds, 13);
    EXPECT_LE(helped.copied_seconds, limits::copies_share_max * 20 + 1e-9);
}

TEST_P(AtTheEnd, AScenarioIsCopiedOnlyIfItEndsClearlySooner) {
    EndRun run(GetParam(), {{1}, {0.8}});
    run.run(like(101, 0.5));
    EXPECT_EQ(run.copied, 0u);
}

TEST_P(AtTheEnd, AJobOfAFewScenariosHasNoCopies) {
    EndRun run(GetParam(), {{1}, {0.1}});
    run.run(like(10, 1));
    EXPECT_EQ(run.copied, 0u) << "one would be a tenth of the work";
}

TEST_P(AtTheEnd, EveryScenarioIsAnsweredWithFewRepeats) {
    std::uint64_t recalled = 0;
    std::uint64_t copied = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937_64 random(seed);
        std::vector<Host> hosts(2 + random() % 6);
        for (Host& host : hosts) {
            host.speed = 0.05 + 0.01 * static_cast<double>(random() % 100);
        }
        hosts.front().speed = 1;
        std::vector<double> scenarios(20 + random() % 200);
        double work = 0;
        for (double& seconds : scenarios) {
            seconds = 0.002 * static_cast<double>(1 + random() % 100);
            work += seconds;
        }
        EndRun run(GetParam(), hosts);
        run.run(scenarios);
        recalled += run.recalled;
        copied += run.copied;
        EXPECT_LE(run.begun_twice, run.copied);
        if (GetParam() == Way::Scenarios) {
            EXPECT_LE(run.copied_seconds, limits::copies_share_max * work + 1e-9);
        } else {
            EXPECT_LE(static_cast<double>(run.copied),
                      limits::copies_share_max * static_cast<double>(scenarios.size()));
        }
    }
    EXPECT_GT(recalled, 30u);
    EXPECT_GT(copied, 50u);
}

INSTANTIATE_TEST_SUITE_P(Ways,
                         AtTheEnd,
                         testing::Values(Way::Scenarios, Way::Places),
                         [](const auto& way) {
                             return way.param == Way::Scenarios ? "Scenarios" : "Places";
                         });

TEST(AtTheEndOfLargeClusters, AnUnansweredRecallBlocksNoOtherHelp) {
    constexpr std::size_t late = 100;
    constexpr std::size_t workers = 2 * late;
    Dispatcher dispatcher;
    std::vector<SendUnit> given(workers + 1);
    std::set<WorkerId> asked;
    const auto act = [&](const Actions& actions) {
        for (const Action& action : actions) {
            if (const auto* batch = std::get_if<SendUnit>(&action);
                batch && batch->copy_of == TaskId{}) {
                given[batch->worker.value] = *batch;
            } else if (const auto* ask = std::get_if<AskBack>(&action)) {
                asked.insert(ask->worker);
            }
        }
    };
    for (std::size_t i = 1; i <= workers; ++i) {
        act(dispatcher.worker_joined(WorkerId{i}, {"w", 1}));
    }
    ClusterOptions options;
    options.strategy = "earliest-finish";
    act(dispatcher.job_opened(job, options, {{TreeId{1}, {1}, {}}, {TreeId{2}, {1}, {}}}));
    constexpr std::uint64_t predicted_ns = 10'000'000'000;
    for (std::uint64_t i = 0; i < workers; ++i) {
        act(dispatcher.scenario_analysed(job, {i, {0}, {0}, 100, predicted_ns}));
    }
    act(dispatcher.input_paused());
    // Each worker has one scenario; only the second half answers, and none obeys a recall.
    dispatcher.time_is(1);
    for (std::size_t i = late + 1; i <= workers; ++i) {
        ASSERT_EQ(given[i].positions.count(), 1u) << i;
        act(dispatcher.answered({WorkerId{i}, given[i].task, job, given[i].positions, 1}));
        act(dispatcher.task_ended(WorkerId{i}, given[i].task));
    }
    // The other workers have no measured rate, so they count as stragglers.
    for (double now = 3; now < 3.1; now += 0.01) {
        dispatcher.time_is(now);
        act(dispatcher.input_paused());
    }
    EXPECT_EQ(asked.size(), late);
}

TEST(AtTheEndOfPaperModes, NothingIsAskedBackOrCopied) {
    for (const std::string_view strategy : {"best-match", "best-match-load", "random", "lowest"}) {
        Dispatcher dispatcher;
        ClusterOptions options;
        options.strategy = strategy;
        options.q = 5;
        Actions actions =
            dispatcher.job_opened(job, options, {{TreeId{1}, {1}, {}}, {TreeId{2}, {1}, {}}});
        const auto keep = [&](const Actions& more) {
            actions.insert(actions.end(), more.begin(), more.end());
        };
        keep(dispatcher.worker_joined(WorkerId{1}, {"w", 1}));
        for (std::uint64_t i = 0; i < 10; ++i) {
            keep(dispatcher.scenario_analysed(job, {i, {0}, {0}, 100, 1'000'000'000}));
        }
        keep(dispatcher.worker_joined(WorkerId{2}, {"w", 1}));
        keep(dispatcher.input_paused());
        dispatcher.time_is(100);
        keep(dispatcher.input_paused());
        for (const Action& action : actions) {
            const auto* batch = std::get_if<SendUnit>(&action);
            ASSERT_NE(batch, nullptr);
            EXPECT_EQ(batch->copy_of, TaskId{});
        }
    }
}

} // namespace
} // namespace cd::tests
