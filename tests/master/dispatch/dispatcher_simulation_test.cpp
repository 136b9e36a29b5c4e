// Proves, on thousands of seeded schedules of joins, deaths, drains, evictions, recalls,
// speculative copies, late and repeated answers and several jobs, that every scenario is answered
// exactly once or given up after enough losses; that no scenario is in two tasks except one and its
// copy; and that the dispatcher's invariants hold after every event.
#include "common/core/limits/master.hpp"
#include "master/dispatch/dispatcher.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>

namespace cd::tests {
namespace {

/// Defects of the simulated environment that the checks must detect.
enum class Sabotage {
    None,
    DropBatch,    ///< A batch does not reach its worker, which stays alive.
    DropScenario, ///< A scenario never reaches the dispatcher.
    DropAnswer,   ///< An answer is dropped after the dispatcher has received it.
};

struct SimulatedTask {
    WorkerId worker;
    JobId job;
    std::vector<std::uint64_t> open;
    bool is_copy = false;
    PositionSet given_back = {};
};

struct SimulatedJob {
    std::uint64_t total = 0;
    std::uint64_t fed = 0;
    bool cancelled = false;
    std::map<std::uint64_t, int> answers; ///< Number of first answers counted.
    std::map<std::uint64_t, std::uint32_t> losses;
    std::map<std::uint64_t, std::uint32_t> told_lost;
    std::set<std::uint64_t> given_up;
};

class Simulation {
  public:
    Simulation(std::uint64_t seed, Sabotage sabotage)
        : random_(seed), sabotage_(sabotage), dispatcher_(options(seed)) {}

    /// Returns the problems found; empty if none.
    std::vector<std::string> run() {
        const std::uint64_t job_count = 1 + below(3);
        for (std::uint64_t i = 1; i <= job_count; ++i) {
            open_job(JobId{i});
        }
        for (int step = 0; step < 400; ++step) {
            random_event();
        }
        finish();
        inspect();
        return problems_;
    }

    [[nodiscard]] std::uint64_t losses() const { return losses_; }
    [[nodiscard]] std::uint64_t gave_up() const { return gave_up_; }
    [[nodiscard]] std::uint64_t batches() const { return batches_; }
    [[nodiscard]] std::uint64_t recalled() const { return recalled_; }
    [[nodiscard]] std::uint64_t copies() const { return copies_; }

  private:
    std::uint64_t below(std::uint64_t bound) { return random_() % bound; }

    /// Options of a small cluster or, for every third seed, of one so large that full scans of
    /// workers are rare.
    static DispatcherOptions options(std::uint64_t seed) {
        DispatcherOptions options;
        if (seed % 3 == 2) {
            options.workers_few = 0;
            options.look_seconds_each = 0.05;
        }
        return options;
    }

    void problem(const std::string& text) { problems_.push_back(text); }

    void open_job(JobId job) {
        ClusterOptions options;
        options.strategy = strategies[below(strategies.size())].name;
        options.q = static_cast<std::uint32_t>(1 + below(6));
        options.v_kb = below(3) == 0 ? 1 : 100;
        options.claim = below(2) == 0;
        options.seed = random_();
        // Jobs may share a tree.
        DispatchTree a{TreeId{below(3)}, std::vector<std::uint32_t>(8, 3)};
        DispatchTree b{TreeId{10 + job.value}, std::vector<std::uint32_t>(5, 2)};
        jobs_[job].total = 20 + below(60);
        const JobRank rank{static_cast<std::int32_t>(job.value % 2),
                           job.value == 1 ? "ann" : "bob"};
        do_actions(dispatcher_.job_opened(job, options, {std::move(a), std::move(b)}, rank));
    }

    void random_event() {
        const std::uint64_t dice = below(100);
        if (dice < 40) {
            feed();
        } else if (dice < 70) {
            answer();
        } else if (dice < 80) {
            end_task();
        } else if (dice < 84) {
            join();
        } else if (dice < 87) {
            lose();
        } else if (dice < 88) {
            below(2) == 0 ? drain() : fall_silent();
        } else if (dice < 91) {
            evict();
        } else if (dice < 94) {
            below(3) == 0 ? hear() : measure();
        } else if (dice < 96) {
            below(4) == 0 ? pause_one() : do_actions(dispatcher_.input_paused());
        } else if (dice < 97) {
            below(2) == 0 ? answer_an_ask() : stand();
        } else if (dice < 99) {
            repeat_an_old_answer();
        } else if (below(20) == 0) {
            cancel();
        }
    }

    void pause_one() {
        const JobId job{1 + below(jobs_.size())};
        if (!jobs_.at(job).cancelled) {
            do_actions(dispatcher_.job_input_paused(job));
        }
    }

    void feed() {
        auto job = jobs_.begin();
        std::advance(job, static_cast<std::ptrdiff_t>(below(jobs_.size())));
        feed(job->first, job->second);
    }

    void feed(JobId id, SimulatedJob& job) {
        if (job.fed == job.total || job.cancelled) {
            return;
        }
        AnalysedScenario scenario;
        scenario.position = job.fed++;
        for (RootIndex root = 0; root < 8; ++root) {
            if (below(3) == 0) {
                scenario.roots_a.push_back(root);
            }
        }
        scenario.roots_b.push_back(static_cast<RootIndex>(below(5)));
        scenario.bytes = below(700);
        scenario.predicted_ns = below(4) == 0 ? 0 : 1'000'000 * (1 + below(80));
        if (sabotage_ == Sabotage::DropScenario && scenario.position == 7) {
            return;
        }
        do_actions(dispatcher_.scenario_analysed(id, std::move(scenario)));
    }

    [[nodiscard]] SimulatedTask* random_task(TaskId& task) {
        if (tasks_.empty()) {
            return nullptr;
        }
        auto place = tasks_.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(below(tasks_.size())));
        task = place->first;
        return &place->second;
    }

    void answer() {
        TaskId id;
        SimulatedTask* task = random_task(id);
        if (task == nullptr || task->open.empty()) {
            return;
        }
        // Threads finish in any order.
        const auto place = static_cast<std::ptrdiff_t>(below(task->open.size()));
        const std::uint64_t scenario = task->open[static_cast<std::size_t>(place)];
        task->open.erase(task->open.begin() + place);
        take_answer(id, *task, scenario);
    }

    void take_answer(TaskId id, const SimulatedTask& task, std::uint64_t scenario) {
        const WorkerId worker = task.worker;
        const JobId job = task.job;
        old_answers_.push_back({worker, job, {scenario}});
        SimulatedJob& content = jobs_.at(job);
        // The first answer counts, unless the job is over or the scenario given up.
        const bool drop = sabotage_ == Sabotage::DropAnswer && !dropped_;
        dropped_ = dropped_ || drop;
        if (!drop && !content.cancelled && !content.given_up.contains(scenario) &&
            !content.answers.contains(scenario)) {
            ++content.answers[scenario];
        }
        const double seconds = 0.001 * static_cast<double>(below(90));
        do_actions(dispatcher_.answered({worker, id, job, PositionRange{scenario, 1}, seconds}));
    }

    void repeat_an_old_answer() {
        if (!old_answers_.empty()) {
            const SimulatedTask old = old_answers_[below(old_answers_.size())];
            do_actions(dispatcher_.answered(
                {old.worker, {}, old.job, PositionRange{old.open.front(), 1}}));
        }
    }

    void end_task() {
        TaskId id;
        SimulatedTask* task = random_task(id);
        if (task != nullptr && below(20) == 0) {
            return lose_on_the_way(id);
        }
        // A sound worker ends a task once it has answered all; one in ten ends it early.
        if (task == nullptr || (!task->open.empty() && below(10) != 0)) {
            return;
        }
        end_task(id);
    }

    void end_task(TaskId id) {
        say_what_was_given_back(id); // The return arrives before the end, or neither does.
        const SimulatedTask task = tasks_.at(id);
        tasks_.erase(id);
        if (!draining_.contains(task.worker)) {
            count_losses(task);
        }
        do_actions(dispatcher_.task_ended(task.worker, id));
    }

    /// Simulates a task that never arrived, or seems so: it counts as no loss.
    void lose_on_the_way(TaskId id) {
        const WorkerId worker = tasks_.at(id).worker;
        tasks_.erase(id);
        do_actions(dispatcher_.task_unbegun(worker, id));
    }

    /// The worker keeps what it has begun and returns the rest; its message may get lost.
    void answer_an_ask() {
        if (asks_.empty()) {
            return;
        }
        const AskBack ask = asks_.front();
        asks_.erase(asks_.begin());
        const auto task = tasks_.find(ask.task);
        if (task == tasks_.end()) {
            return;
        }
        SimulatedTask& content = task->second;
        for (const std::uint64_t scenario : ask.positions.list()) {
            if (below(3) != 0 && std::erase(content.open, scenario) != 0) {
                content.given_back.add({scenario, 1});
            }
        }
        if (below(5) != 0) {
            say_what_was_given_back(ask.task);
        }
    }

    void say_what_was_given_back(TaskId id) {
        const SimulatedTask& task = tasks_.at(id);
        do_actions(dispatcher_.task_recalled(task.worker, id, task.given_back));
    }

    /// A worker reconnects and reports its tasks.
    void stand() {
        if (workers_.empty()) {
            return;
        }
        const WorkerId worker = random_worker();
        std::erase_if(asks_, [&](const AskBack& ask) { return ask.worker == worker; });
        do_actions(dispatcher_.worker_silent(worker));
        std::vector<TaskId> its;
        for (const auto& [id, task] : tasks_) {
            if (task.worker == worker) {
                its.push_back(id);
            }
        }
        for (const TaskId id : its) {
            say_what_was_given_back(id);
        }
        silent_.erase(worker);
        do_actions(dispatcher_.worker_heard(worker));
    }

    [[nodiscard]] bool stands_elsewhere(const SimulatedTask& task, std::uint64_t scenario) const {
        return std::ranges::any_of(tasks_, [&](const auto& other) {
            return &other.second != &task && other.second.job == task.job &&
                   other.second.worker != task.worker &&
                   std::ranges::count(other.second.open, scenario) != 0;
        });
    }

    void count_losses(const SimulatedTask& task) {
        for (const std::uint64_t scenario : task.open) {
            if (task.is_copy && stands_elsewhere(task, scenario)) {
                continue; // Nothing is lost.
            }
            ++jobs_.at(task.job).losses[scenario];
            ++losses_;
        }
    }

    void join() {
        if (workers_.size() < 6) {
            const WorkerId worker{++worker_last_};
            workers_.insert(worker);
            WorkerFacts facts{"w", static_cast<std::uint32_t>(1 + below(8))};
            facts.weight = below(3) == 0 ? 0.25 : 1;
            facts.cache_bytes = below(2) * 3000;
            do_actions(dispatcher_.worker_joined(worker, facts));
        }
    }

    [[nodiscard]] WorkerId random_worker() {
        auto place = workers_.begin();
        std::advance(place, static_cast<std::ptrdiff_t>(below(workers_.size())));
        return *place;
    }

    void lose() {
        if (!workers_.empty()) {
            lose(random_worker());
        }
    }

    void lose(WorkerId worker) {
        workers_.erase(worker);
        for (const auto& [id, task] : tasks_) {
            if (task.worker == worker) {
                count_losses(task);
                for (const std::uint64_t scenario : task.given_back.list()) {
                    ++jobs_.at(task.job).losses[scenario]; // In case the return was lost.
                }
            }
        }
        std::erase_if(tasks_, [&](const auto& task) { return task.second.worker == worker; });
        do_actions(dispatcher_.worker_lost(worker));
    }

    void drain() {
        if (!workers_.empty()) {
            const WorkerId worker = random_worker();
            draining_.insert(worker);
            do_actions(dispatcher_.worker_draining(worker));
        }
    }

    void fall_silent() {
        if (!workers_.empty()) {
            const WorkerId worker = random_worker();
            silent_.insert(worker);
            do_actions(dispatcher_.worker_silent(worker));
        }
    }

    void hear() {
        if (!workers_.empty()) {
            const WorkerId worker = random_worker();
            silent_.erase(worker);
            do_actions(dispatcher_.worker_heard(worker));
        }
    }

    void evict() {
        if (!workers_.empty()) {
            const std::vector<RootIndex> roots = {static_cast<RootIndex>(below(8)),
                                                  static_cast<RootIndex>(below(8))};
            do_actions(dispatcher_.roots_evicted(random_worker(), TreeId{below(14)}, roots));
        }
    }

    /// Reports random measurements, which change the distribution and nothing else.
    void measure() {
        now_ += 0.001 * static_cast<double>(below(200));
        dispatcher_.time_is(now_);
        TaskId task;
        if (const SimulatedTask* found = random_task(task); found != nullptr) {
            dispatcher_.transfer_measured(
                found->worker, below(1'000'000), 0.001 * static_cast<double>(below(50)));
        }
        if (!workers_.empty()) {
            const std::vector<RootIndex> roots = {static_cast<RootIndex>(below(8))};
            dispatcher_.roots_arrived(random_worker(), TreeId{below(14)}, roots);
        }
        dispatcher_.check_invariants();
    }

    void cancel() {
        auto job = jobs_.begin();
        std::advance(job, static_cast<std::ptrdiff_t>(below(jobs_.size())));
        if (!job->second.cancelled) {
            job->second.cancelled = true;
            do_actions(dispatcher_.job_closed(job->first));
        }
    }

    void do_actions(const Actions& actions) {
        dispatcher_.check_invariants();
        for (const Action& action : actions) {
            if (const auto* batch = std::get_if<SendUnit>(&action)) {
                take_batch(*batch);
            } else if (const auto* ask = std::get_if<AskBack>(&action)) {
                asks_.push_back(*ask);
            } else if (const auto* given = std::get_if<UnitsReturned>(&action)) {
                recalled_ += given->positions;
            } else if (const auto* loser = std::get_if<CallOff>(&action)) {
                call_off(*loser);
            } else if (std::holds_alternative<SendHint>(action)) {
                // A hint only serves the cache.
            } else if (const auto* lost = std::get_if<PositionsLost>(&action)) {
                for (const std::uint64_t scenario : lost->positions.list()) {
                    ++jobs_.at(lost->job).told_lost[scenario];
                }
            } else {
                take_give_up(std::get<GiveUp>(action));
            }
        }
    }

    /// The worker may have finished the scenario already.
    void call_off(const CallOff& loser) {
        const auto task = tasks_.find(loser.task);
        if (task == tasks_.end()) {
            problem("a task is called off that does not exist");
            return;
        }
        for (const std::uint64_t scenario : loser.positions.list()) {
            if (below(2) == 0) {
                std::erase(task->second.open, scenario);
            }
            if (!jobs_.at(task->second.job).answers.contains(scenario) && !dropped_) {
                problem("a scenario is called off that nobody has answered");
            }
        }
    }

    void take_batch(const SendUnit& batch) {
        ++batches_;
        const bool is_copy = batch.copy_of != TaskId{};
        copies_ += is_copy ? 1 : 0;
        const SimulatedJob& job = jobs_.at(batch.job);
        if (!workers_.contains(batch.worker) || draining_.contains(batch.worker) ||
            silent_.contains(batch.worker)) {
            problem("a batch for a worker that takes none");
        }
        for (const std::uint64_t scenario : batch.positions.list()) {
            if (scenario >= job.fed || job.answers.contains(scenario) ||
                job.given_up.contains(scenario) || job.cancelled) {
                problem("a batch with a scenario that needs no answer");
            }
            std::int64_t tasks = 0;
            for (const auto& [id, task] : tasks_) {
                tasks += task.job == batch.job ? std::ranges::count(task.open, scenario) : 0;
            }
            // The first task may have returned the scenario in a message still in flight.
            if (tasks > (is_copy ? 1 : 0)) {
                problem("a scenario stands in two tasks");
            }
        }
        if (sabotage_ == Sabotage::DropBatch && faults_have_stopped_ && !dropped_) {
            dropped_ = true;
            return;
        }
        tasks_[batch.task] = {batch.worker, batch.job, batch.positions.list(), is_copy};
    }

    void take_give_up(const GiveUp& action) {
        SimulatedJob& job = jobs_.at(action.job);
        ++gave_up_;
        if (job.losses[action.position] < limits::scenario_losses_max) {
            problem("a scenario was given up too early");
        }
        if (job.told_lost[action.position] + 1 < limits::scenario_losses_max) {
            problem("a scenario was given up of whose losses nobody was told");
        }
        if (!job.given_up.insert(action.position).second || job.answers.contains(action.position)) {
            problem("a scenario was given up that had its end already");
        }
    }

    /// Ends the faults: all input arrives, sound workers join, and everything must finish.
    void finish() {
        for (const WorkerId worker : std::set(draining_)) {
            if (workers_.contains(worker)) {
                lose(worker);
            }
        }
        for (const WorkerId worker : std::set(silent_)) {
            silent_.erase(worker);
            do_actions(dispatcher_.worker_heard(worker));
        }
        faults_have_stopped_ = true;
        join();
        for (auto& [id, job] : jobs_) {
            while (job.fed < job.total && !job.cancelled) {
                feed(id, job);
            }
        }
        do_actions(dispatcher_.input_paused());
        for (int step = 0; step < 100'000 && !tasks_.empty(); ++step) {
            TaskId id;
            const SimulatedTask* task = random_task(id);
            if (below(4) == 0) {
                below(3) == 0 ? measure() : answer_an_ask();
                do_actions(dispatcher_.input_paused());
            } else if (task->open.empty()) {
                end_task(id);
            } else {
                answer();
            }
        }
    }

    void inspect() {
        if (!tasks_.empty()) {
            problem("tasks never came to an end");
        }
        if (dispatcher_.unsent() != 0) {
            problem("scenarios were left unsent");
        }
        for (const WorkerId worker : dispatcher_.workers()) {
            if (dispatcher_.worker_status(worker).working != 0) {
                problem("a worker is said to be working");
            }
        }
        for (const auto& [id, job] : jobs_) {
            for (std::uint64_t scenario = 0; scenario < job.total && !job.cancelled; ++scenario) {
                const auto found = job.answers.find(scenario);
                const int ends = (found == job.answers.end() ? 0 : found->second) +
                                 (job.given_up.contains(scenario) ? 1 : 0);
                if (ends != 1) {
                    problem("scenario " + std::to_string(scenario) + " of job " +
                            std::to_string(id.value) + " came to " + std::to_string(ends) +
                            " ends");
                }
            }
        }
    }

    std::mt19937_64 random_;
    Sabotage sabotage_;
    bool dropped_ = false;
    bool faults_have_stopped_ = false;
    double now_ = 0;
    Dispatcher dispatcher_;
    std::map<JobId, SimulatedJob> jobs_;
    std::set<WorkerId> workers_;
    std::set<WorkerId> draining_;
    std::set<WorkerId> silent_;
    std::uint64_t worker_last_ = 0;
    std::map<TaskId, SimulatedTask> tasks_;
    std::vector<SimulatedTask> old_answers_;
    std::vector<std::string> problems_;
    std::uint64_t losses_ = 0;
    std::uint64_t gave_up_ = 0;
    std::uint64_t batches_ = 0;
    std::vector<AskBack> asks_; ///< In flight.
    std::uint64_t recalled_ = 0;
    std::uint64_t copies_ = 0;
};

TEST(DispatcherSimulation, EveryScenarioComesToExactlyOneEnd) {
    constexpr std::uint64_t seeds = 1500;
    std::uint64_t losses = 0;
    std::uint64_t gave_up = 0;
    std::uint64_t batches = 0;
    std::uint64_t recalled = 0;
    std::uint64_t copies = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Simulation simulation(seed, Sabotage::None);
        const auto problems = simulation.run();
        ASSERT_TRUE(problems.empty()) << problems.front();
        losses += simulation.losses();
        gave_up += simulation.gave_up();
        batches += simulation.batches();
        recalled += simulation.recalled();
        copies += simulation.copies();
    }
    // The runs really exercised the faults.
    EXPECT_GT(batches, seeds * 10);
    EXPECT_GT(losses, seeds * 3);
    EXPECT_GT(gave_up, seeds / 10);
    EXPECT_GT(recalled, seeds / 10);
    EXPECT_GT(copies, seeds / 30);
}

TEST(DispatcherSimulation, TheSimulationNoticesDroppedScenarios) {
    // A job may be cancelled before the defect shows, so not every seed must detect it.
    for (const Sabotage sabotage :
         {Sabotage::DropBatch, Sabotage::DropScenario, Sabotage::DropAnswer}) {
        int noticed = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            noticed += Simulation(seed, sabotage).run().empty() ? 0 : 1;
        }
        EXPECT_GE(noticed, 10) << static_cast<int>(sabotage);
    }
}

} // namespace
} // namespace cd::tests
