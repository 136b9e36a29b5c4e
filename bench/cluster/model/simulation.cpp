#include "bench/cluster/model/simulation.hpp"

#include "bench/accuracy/isolate.hpp"
#include "bench/cluster/model/master_model.hpp"
#include "bench/cluster/model/platform.hpp"
#include "bench/cluster/model/worker_model.hpp"

#include <simgrid/s4u.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

namespace s4u = simgrid::s4u;

class Simulation {
  public:
    Simulation(const Workload& workload, const SimulationOptions& options)
        : workload_(workload),
          options_(options),
          master_(
              workload, options.dispatch, options.ahead, options.peers, 0, options.helps_at_end),
          to_master_("master"),
          work_available_(s4u::ConditionVariable::create()),
          analysts_lock_(s4u::Mutex::create()),
          results_came_(s4u::Semaphore::create(0)),
          results_merged_(s4u::Semaphore::create(0)),
          results_written_(s4u::Semaphore::create(0)) {}

    Outcome run(s4u::Engine& engine) {
        const std::uint32_t shared = options_.cluster.shared_cores;
        const std::uint32_t cores = shared != 0 ? shared : 1 + options_.analysts;
        const Platform platform = build_platform(options_.cluster, workload_.slow_ratio, cores);
        std::vector<std::uint32_t> threads;
        for (const WorkerPlace& place : platform.workers) {
            threads.push_back(place.threads);
            workers_.push_back(std::make_unique<Worker>(threads.size(), place.threads, workload_));
        }
        s4u::Actor::create("master", platform.master, [this, threads] { run_master(threads); });
        for (std::size_t i = 0; i < platform.workers.size(); ++i) {
            start_worker(*workers_[i], platform.workers[i].host, platform.master);
        }
        for (std::uint32_t i = 0; i < options_.analysts; ++i) {
            s4u::Actor::create("analyst", platform.master, [this] { run_analyst(); });
            s4u::Actor::create("intake", platform.master, [this] { run_intake(); });
        }
        s4u::Actor::create("journal", platform.master, [this] { run_journal(); });
        engine.run();
        return outcome();
    }

  private:
    // ---- The master ---------------------------------------------------------------------------

    void run_master(const std::vector<std::uint32_t>& threads) {
        to_master_.open();
        send(master_.start(threads));
        while (!master_.is_done()) {
            if (to_master_.has_message()) {
                take_message();
            } else if (options_.analysts != 0 || !analyse_one()) {
                take_message();
            }
            wake_analysts();
        }
        while (unwritten_ != 0) {
            results_written_->acquire();
        }
        outcome_.seconds = s4u::Engine::get_clock();
        is_over_ = true;
        wake_analysts();
        for (std::uint32_t i = 0; i < options_.analysts; ++i) {
            results_came_->release();
        }
        results_merged_->release();
        for (const auto& worker : workers_) {
            post(*worker, {WorkerId{}, Ended{}, bytes_of(ToWorker(Ended{}), workload_)});
        }
        to_master_.close();
    }

    void take_message() {
        const std::unique_ptr<ToMaster> message = to_master_.get();
        if (std::holds_alternative<Analysed>(*message)) {
            master_spends(options_.dispatch_seconds);
        }
        if (auto* results = std::get_if<ResultsSent>(message.get())) {
            if (is_intake_apart() && !results->is_checked) {
                unchecked_.push_back(std::move(*results));
                results_came_->release();
                return;
            }
            unwritten_ += results->scenarios.size();
            merged_.push_back(results->scenarios.size());
            results_merged_->release();
        }
        tell_time();
        send(std::visit([this](const auto& content) { return master_.take(content); }, *message));
    }

    bool analyse_one() {
        const auto scenario = master_.next_to_analyse();
        if (!scenario) {
            return false;
        }
        master_spends(workload_.scenario(*scenario).analysis_seconds + options_.dispatch_seconds);
        tell_time();
        send(master_.take(Analysed{*scenario}));
        return true;
    }

    void tell_time() { send(master_.time_is(s4u::Engine::get_clock())); }

    void send(std::vector<Letter> letters) {
        for (Letter& letter : letters) {
            if (options_.pipe_bytes_per_second > 0) {
                master_spends(static_cast<double>(letter.bytes) / options_.pipe_bytes_per_second);
            }
            post(*workers_[letter.to.value - 1], std::move(letter));
        }
    }

    void master_spends(double seconds) {
        outcome_.master_seconds += seconds;
        spend(seconds);
    }

    // Holds the lock, so that no analyst misses the wake-up between its check and its wait.
    void wake_analysts() {
        if (options_.analysts != 0) {
            const std::unique_lock lock(*analysts_lock_);
            work_available_->notify_all();
        }
    }

    void run_analyst() {
        while (const auto scenario = wait_for_scenario()) {
            spend(workload_.scenario(*scenario).analysis_seconds);
            to_master_.put(Analysed{*scenario}, 0);
        }
    }

    // ---- What becomes of results, as in the product: other threads check and write them ---------

    /// With a single master thread, results cost it nothing, as in the paper's setting.
    [[nodiscard]] bool is_intake_apart() const { return options_.analysts != 0; }

    void run_intake() {
        for (results_came_->acquire(); !is_over_; results_came_->acquire()) {
            ResultsSent results = std::move(unchecked_.front());
            unchecked_.pop_front();
            spend(static_cast<double>(results.scenarios.size()) * workload_.results.intake_seconds);
            results.is_checked = true;
            to_master_.put(std::move(results), 0);
        }
    }

    void run_journal() {
        for (results_merged_->acquire(); !is_over_; results_merged_->acquire()) {
            const std::size_t count = merged_.front();
            merged_.pop_front();
            spend(static_cast<double>(count) * workload_.results.journal_seconds);
            unwritten_ -= count;
            results_written_->release();
        }
    }

    /// Returns nothing at the end.
    std::optional<std::uint64_t> wait_for_scenario() {
        const std::unique_lock lock(*analysts_lock_);
        while (!is_over_) {
            if (const auto scenario = master_.next_to_analyse()) {
                return scenario;
            }
            work_available_->wait(lock);
        }
        return std::nullopt;
    }

    // ---- A worker -----------------------------------------------------------------------------

    /// A session that receives, and threads that compute, as in the real worker.
    struct Worker {
        Worker(std::size_t id, std::uint32_t thread_count, const Workload& workload)
            : model(WorkerId{id}, workload),
              inbox("worker " + std::to_string(id)),
              posted(s4u::Semaphore::create(0)),
              finished(s4u::Semaphore::create(0)),
              work(s4u::Semaphore::create(0)),
              threads(thread_count) {}

        WorkerModel model;
        Inbox<ToWorker> inbox;
        std::deque<Letter> outbox;                     ///< At the master.
        s4u::SemaphorePtr posted;                      ///< Counts the letters in the outbox.
        std::deque<ResultsSent> unpacked;              ///< Results to be sent.
        s4u::SemaphorePtr finished;                    ///< Counts the unpacked results.
        std::deque<BlocksSent> unopened;               ///< Opened before scenarios run.
        s4u::SemaphorePtr work;                        ///< Counts the tasks that a thread can take.
        std::map<std::uint64_t, s4u::ExecPtr> running; ///< By scenario.
        std::uint32_t threads;
        bool is_over = false;
    };

    /// Times of one worker thread.
    struct ThreadTimes {
        double first = 0; ///< Start of the thread's first scenario.
        double last = 0;
        double busy = 0;
        double speed = 1;
    };

    static void post(Worker& worker, Letter letter) {
        worker.outbox.push_back(std::move(letter));
        worker.posted->release();
    }

    /// A worker has one connection: its messages arrive one after the other.
    static void run_connection(Worker& worker) {
        bool is_last = false;
        while (!is_last) {
            worker.posted->acquire();
            Letter letter = std::move(worker.outbox.front());
            worker.outbox.pop_front();
            is_last = std::holds_alternative<Ended>(letter.content);
            worker.inbox.put_and_wait(std::move(letter.content), letter.bytes);
        }
    }

    void start_worker(Worker& worker, s4u::Host* host, s4u::Host* master) {
        s4u::Actor::create("connection", master, [&worker] { run_connection(worker); });
        s4u::Actor::create("session", host, [this, &worker] { run_session(worker); });
        s4u::Actor::create("packer", host, [this, &worker] { run_packer(worker); });
        for (std::uint32_t i = 0; i < worker.threads; ++i) {
            s4u::Actor::create("thread", host, [this, &worker] { run_thread(worker); });
        }
    }

    void run_session(Worker& worker) {
        worker.inbox.open();
        while (!worker.is_over) {
            const std::unique_ptr<ToWorker> message = worker.inbox.get();
            std::visit([&](const auto& content) { take(worker, content); }, *message);
        }
        worker.inbox.close();
    }

    void take(Worker& worker, const BatchSent& batch) {
        const std::size_t ready_before = worker.model.ready_count();
        auto wanted = worker.model.take(batch);
        // Runs first, so that waiting threads of this worker can start.
        offer(worker, worker.model.ready_count() - ready_before);
        if (wanted) {
            put_to_master(std::move(*wanted));
        }
    }

    void take(Worker& worker, const Hinted& hint) {
        worker.model.take(hint);
        ask_ahead(worker);
    }
    void ask_ahead(Worker& worker) {
        if (auto wanted = worker.model.ahead()) {
            put_to_master(std::move(*wanted));
        }
    }

    /// The threads share the opening.
    void take(Worker& worker, const BlocksSent& message) {
        const std::size_t count = message.blocks.size();
        std::size_t begin = 0;
        for (std::uint32_t i = 1; i <= worker.threads; ++i) {
            const std::size_t end = count * i / worker.threads;
            if (end > begin) {
                worker.unopened.push_back({{message.blocks.begin() + offset(begin),
                                            message.blocks.begin() + offset(end)}});
                offer(worker, 1);
            }
            begin = end;
        }
    }

    void take(Worker& worker, const FetchDirected& directed) {
        ToWorker asked = PeerAsked{worker.model.id(), directed.blocks};
        const std::uint64_t bytes = bytes_of(asked, workload_);
        workers_[directed.source.value - 1]->inbox.put(std::move(asked), bytes);
    }

    /// The source's uploads share its link.
    void take(Worker& /*source*/, const PeerAsked& asked) {
        ToWorker blocks = BlocksSent{asked.blocks};
        const std::uint64_t bytes = bytes_of(blocks, workload_);
        outcome_.peer_bytes += bytes;
        workers_[asked.asker.value - 1]->inbox.put(std::move(blocks), bytes);
    }

    void take(Worker& worker, const AskedBack& asked) {
        put_to_master(worker.model.take(asked));
        send_results(worker); // A task with no scenarios left ends.
    }

    void take(Worker& worker, const CalledOff& loser) {
        if (worker.model.take(loser)) {
            worker.running.at(loser.scenario)->cancel();
        }
        send_results(worker);
    }

    void take(Worker& worker, const Ended& /*message*/) {
        worker.is_over = true;
        offer(worker, worker.threads);
        worker.finished->release();
    }

    static std::ptrdiff_t offset(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

    static void offer(Worker& worker, std::size_t things) {
        for (std::size_t i = 0; i < things; ++i) {
            worker.work->release();
        }
    }

    void run_thread(Worker& worker) {
        ThreadTimes& times = thread_times_.emplace_back();
        times.speed = s4u::this_actor::get_host()->get_speed() / fast_speed;
        for (worker.work->acquire(); !worker.is_over; worker.work->acquire()) {
            if (!worker.unopened.empty()) {
                const BlocksSent blocks = std::move(worker.unopened.front());
                worker.unopened.pop_front();
                open(worker, blocks);
            } else if (worker.model.ready_count() != 0) { // Otherwise the scenario was returned.
                run_scenario(worker, worker.model.next(), times);
            }
        }
    }

    void open(Worker& worker, const BlocksSent& blocks) {
        spend(worker.model.open_seconds(blocks));
        const std::size_t ready_before = worker.model.ready_count();
        BlocksHeld held = worker.model.opened(blocks);
        offer(worker, worker.model.ready_count() - ready_before);
        if (!held.blocks.empty()) {
            put_to_master(std::move(held));
        }
        ask_ahead(worker);
    }

    void run_scenario(Worker& worker, std::uint64_t scenario, ThreadTimes& times) {
        const double seconds = workload_.scenario(scenario).work_seconds;
        const double begin = s4u::Engine::get_clock();
        const s4u::ExecPtr exec = s4u::this_actor::exec_init(seconds * fast_speed);
        worker.running[scenario] = exec;
        exec->start();
        try {
            exec->wait();
        } catch (const simgrid::CancelException&) {
            // Another worker answered first.
        }
        worker.running.erase(scenario);
        outcome_.work_seconds += seconds;
        const double now = s4u::Engine::get_clock();
        times.first = times.busy == 0 ? begin : times.first;
        times.last = now;
        times.busy += now - begin;
        worker.model.ran(scenario, now, now - begin);
        send_results(worker);
    }

    void send_results(Worker& worker) {
        // A worker that waits for blocks has time to send its results.
        const double period = worker.model.ready_count() != 0
                                  ? options_.results_period
                                  : std::min(options_.results_period, idle_period());
        for (ResultsSent& results : worker.model.due(s4u::Engine::get_clock(), period)) {
            worker.unpacked.push_back(std::move(results));
            worker.finished->release();
        }
    }

    /// Packs outgoing messages on the worker's network thread.
    void run_packer(Worker& worker) {
        for (worker.finished->acquire(); !worker.is_over; worker.finished->acquire()) {
            ResultsSent results = std::move(worker.unpacked.front());
            worker.unpacked.pop_front();
            spend(static_cast<double>(results.scenarios.size()) *
                  workload_.results.packing_seconds);
            put_to_master(std::move(results));
        }
    }

    /// While idle, results are kept only if they wait for their task's end anyway.
    [[nodiscard]] double idle_period() const {
        return options_.results_period == std::numeric_limits<double>::infinity()
                   ? options_.results_period
                   : 0;
    }

    void put_to_master(ToMaster message) {
        const std::uint64_t bytes = bytes_of(message, workload_);
        outcome_.received_bytes += bytes;
        to_master_.put(std::move(message), bytes);
    }

    [[nodiscard]] Outcome outcome() const {
        const MasterCounts& counts = master_.counts();
        Outcome outcome = outcome_;
        outcome.answered = counts.answered;
        outcome.answered_again = counts.answered_again;
        outcome.batches = counts.batches;
        outcome.recalled = counts.recalled;
        outcome.copies = counts.copies;
        outcome.wants = counts.wants;
        outcome.blocks = counts.blocks;
        outcome.block_bytes = counts.block_bytes;
        outcome.sent_bytes = counts.sent_bytes;
        outcome.dispatcher_us = 1e6 * counts.dispatcher_seconds /
                                static_cast<double>(std::max<std::size_t>(workload_.count(), 1));
        add_idle_shares(outcome);
        for (const auto& worker : workers_) {
            const WorkerModel& model = worker->model;
            outcome.blocks_received += model.received_blocks();
            outcome.memory_bytes_max = std::max(outcome.memory_bytes_max, model.memory_bytes());
            outcome.memory_bytes_sum += model.memory_bytes();
        }
        return outcome;
    }

    void add_idle_shares(Outcome& outcome) const {
        double all = 0;
        for (const ThreadTimes& times : thread_times_) {
            all += times.speed * outcome.seconds;
        }
        for (const ThreadTimes& times : thread_times_) {
            const double last = times.busy > 0 ? times.last : outcome.seconds;
            const double first = times.busy > 0 ? times.first : outcome.seconds;
            outcome.start_share += times.speed * first / all;
            outcome.between_share += times.speed * (last - first - times.busy) / all;
            outcome.tail_share += times.speed * (outcome.seconds - last) / all;
        }
    }

    const Workload& workload_;
    const SimulationOptions& options_;
    MasterModel master_;
    Inbox<ToMaster> to_master_;
    std::vector<std::unique_ptr<Worker>> workers_;
    s4u::ConditionVariablePtr work_available_;
    s4u::MutexPtr analysts_lock_;
    bool is_over_ = false;
    std::deque<ResultsSent> unchecked_;
    s4u::SemaphorePtr results_came_; ///< Counts the messages of results.
    std::deque<std::size_t> merged_; ///< Number of scenarios in each message.
    s4u::SemaphorePtr results_merged_;
    std::uint64_t unwritten_ = 0; ///< Scenarios received and not yet written.
    s4u::SemaphorePtr results_written_;
    std::deque<ThreadTimes> thread_times_;
    Outcome outcome_;
};

} // namespace

Outcome simulate(const Workload& workload, const SimulationOptions& options) {
    std::string program = "simulate";
    std::string quiet = "--log=root.thresh:warning";
    std::array<char*, 3> arguments{program.data(), quiet.data(), nullptr};
    int count = 2;
    s4u::Engine engine(&count, arguments.data());
    return Simulation(workload, options).run(engine);
}

std::optional<Outcome> simulate_apart(const Workload& workload,
                                      const SimulationOptions& options,
                                      std::chrono::seconds limit) {
    const SharedArray<Outcome> shared(1);
    const Ending ending = run_isolated(limit, [&] { shared[0] = simulate(workload, options); });
    return ending == Ending::Done ? std::optional(shared[0]) : std::nullopt;
}

} // namespace cd::bench
