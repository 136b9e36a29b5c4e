#include "bench/cluster/model/simulation.hpp"

#include "bench/accuracy/isolate.hpp"
#include "bench/cluster/model/platform.hpp"
#include "bench/cluster/model/simulated_master.hpp"
#include "bench/cluster/model/worker_model.hpp"

#include <simgrid/s4u.hpp>

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cd::bench {

namespace {

namespace s4u = simgrid::s4u;

class Simulation {
  public:
    Simulation(const Workload& workload, const SimulationOptions& options)
        : workload_(workload),
          options_(options),
          master_(workload, master_options(options, workload.count())),
          to_master_("master"),
          work_(s4u::Semaphore::create(0)),
          entries_(s4u::Semaphore::create(0)) {}

    Outcome run(s4u::Engine& engine) {
        const std::uint32_t shared = options_.cluster.shared_cores;
        const std::uint32_t cores = shared != 0 ? shared : 1 + options_.analysts;
        const Platform platform = build_platform(options_.cluster, workload_.slow_ratio, cores);
        std::vector<std::uint32_t> threads;
        for (const WorkerPlace& place : platform.workers) {
            threads.push_back(place.threads);
            workers_.push_back(std::make_unique<Worker>(threads.size(), place.threads, workload_));
            if (is_client_first(options_)) {
                workers_.back()->model.take_turns();
            }
        }
        s4u::Actor::create("master", platform.master, [this, threads] { run_master(threads); });
        for (std::size_t i = 0; i < platform.workers.size(); ++i) {
            start_worker(*workers_[i], platform.workers[i].host, platform.master);
        }
        for (std::uint32_t i = 0; i < options_.analysts; ++i) {
            s4u::Actor::create("pool thread", platform.master, [this] { run_pool_thread(); });
        }
        s4u::Actor::create("journal", platform.master, [this] { run_journal(); });
        engine.run();
        return outcome();
    }

  private:
    // ---- The master ---------------------------------------------------------------------------

    using Letters = SimulatedMaster::Letters;
    // To the master's thread: a message of a worker, the work of a pool thread, or a commit.
    struct FromWorker {
        WorkerId worker;
        Message message;
    };
    struct Committed {};
    using Event = std::variant<FromWorker, SimulatedMaster::PoolRun, Committed>;

    static bool is_client_first(const SimulationOptions& options) {
        return options.variation == Variation::ClientFirst;
    }

    static MasterOptions master_options(const SimulationOptions& options, std::uint64_t count) {
        MasterOptions master;
        master.dispatch = options.dispatch;
        master.analysis = options.analysis;
        master.variation = options.variation;
        master.feed.waiting_max = is_client_first(options) ? count + 1 : options.ahead;
        // The paper's master analyses one scenario after the other.
        master.feed.block_scenarios = options.analysts == 0 ? 1 : master.feed.block_scenarios;
        master.peers = options.peers;
        master.helps_at_end = options.helps_at_end;
        master.pool_threads = std::max(1u, options.analysts);
        return master;
    }

    void run_master(const std::vector<std::uint32_t>& threads) {
        to_master_.open();
        if (is_client_first(options_)) {
            send(master_.start({}));
            while (master_.has_pool_work()) {
                analyse();
            }
            send(master_.join(threads));
        } else {
            send(master_.start(threads));
        }
        offer_work();
        while (!master_.is_done()) {
            if (to_master_.has_message() || options_.analysts != 0 || !master_.has_pool_work()) {
                take(*to_master_.get());
            } else {
                analyse();
            }
            offer_work();
        }
        outcome_.seconds = s4u::Engine::get_clock();
        is_over_ = true;
        for (std::uint32_t i = 0; i < options_.analysts; ++i) {
            work_->release();
        }
        entries_->release();
        for (const auto& worker : workers_) {
            post(*worker, {WorkerId{}, Terminate{}, bytes_of(Terminate{}, workload_)});
        }
        to_master_.close();
    }

    /// Does one piece of a pool thread's work on the master's thread.
    void analyse() {
        SimulatedMaster::PoolRun run = master_.start_pool_work();
        master_spends(run.seconds);
        take(std::move(run));
    }

    void take(Event event) {
        tell_time();
        send(std::visit([this](auto& content) { return handle(std::move(content)); }, event));
    }
    Letters handle(const FromWorker& from) { return master_.take(from.worker, from.message); }
    Letters handle(SimulatedMaster::PoolRun run) {
        master_spends(options_.dispatch_seconds * static_cast<double>(run.analysed));
        return master_.take(std::move(run));
    }
    Letters handle(Committed /*event*/) {
        --entries_offered_;
        return master_.commit();
    }

    void tell_time() { send(master_.time_is(s4u::Engine::get_clock())); }

    void send(Letters letters) {
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

    /// Wakes the threads that can go on.
    void offer_work() {
        if (options_.analysts != 0 && master_.has_pool_work()) {
            for (std::uint32_t i = 0; i < options_.analysts; ++i) {
                work_->release();
            }
        }
        for (; entries_offered_ < master_.uncommitted().size(); ++entries_offered_) {
            entries_to_write_.push_back(master_.uncommitted()[entries_offered_]);
            entries_->release();
        }
    }

    void run_pool_thread() {
        for (work_->acquire(); !is_over_; work_->acquire()) {
            while (master_.has_pool_work()) {
                SimulatedMaster::PoolRun run = master_.start_pool_work();
                spend(run.seconds);
                to_master_.put(std::move(run), 0);
            }
        }
    }

    void run_journal() {
        for (entries_->acquire(); !is_over_; entries_->acquire()) {
            const std::size_t count = entries_to_write_.front();
            entries_to_write_.pop_front();
            spend(static_cast<double>(count) * workload_.results.journal_seconds);
            to_master_.put(Committed{}, 0);
        }
    }

    // ---- A worker -----------------------------------------------------------------------------

    struct ToWorker {
        Message message;
        WorkerId asker = {}; ///< The worker that sends a PeerFetch.
    };
    /// A session that receives, and threads that compute, as in the real worker.
    struct Worker {
        Worker(std::size_t id, std::uint32_t thread_count, const Workload& workload)
            : model(WorkerId{id}, workload),
              inbox("worker " + std::to_string(id)),
              posted(s4u::Semaphore::create(0)),
              told(s4u::Semaphore::create(0)),
              finished(s4u::Semaphore::create(0)),
              work(s4u::Semaphore::create(0)),
              threads(thread_count) {}

        WorkerModel model;
        Inbox<ToWorker> inbox;
        std::deque<Letter> outbox;                     ///< At the master.
        s4u::SemaphorePtr posted;                      ///< Counts the letters in the outbox.
        std::deque<Message> untold;                    ///< Messages to the master.
        s4u::SemaphorePtr told;                        ///< Counts the messages to the master.
        std::deque<Message> unpacked;                  ///< Results and ends of tasks to be sent.
        s4u::SemaphorePtr finished;                    ///< Counts the unpacked messages.
        std::deque<Subtrees> unopened;                 ///< Opened before scenarios run.
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
            is_last = std::holds_alternative<Terminate>(letter.content);
            worker.inbox.put_and_wait({std::move(letter.content)}, letter.bytes);
        }
    }

    /// In the other direction, too.
    void run_reports(Worker& worker) {
        for (;;) {
            worker.told->acquire();
            Message message = std::move(worker.untold.front());
            worker.untold.pop_front();
            const std::uint64_t bytes = bytes_of(message, workload_);
            outcome_.received_bytes += bytes;
            to_master_.put_and_wait(FromWorker{worker.model.id(), std::move(message)}, bytes);
        }
    }

    void start_worker(Worker& worker, s4u::Host* host, s4u::Host* master) {
        s4u::Actor::create("connection", master, [&worker] { run_connection(worker); });
        s4u::Actor::create("reports", host, [this, &worker] { run_reports(worker); })->daemonize();
        s4u::Actor::create("session", host, [this, &worker] { run_session(worker); });
        s4u::Actor::create("packer", host, [this, &worker] { run_packer(worker); });
        for (std::uint32_t i = 0; i < worker.threads; ++i) {
            s4u::Actor::create("thread", host, [this, &worker] { run_thread(worker); });
        }
    }

    void run_session(Worker& worker) {
        worker.inbox.open();
        while (!worker.is_over) {
            const std::unique_ptr<ToWorker> got = worker.inbox.get();
            if (const auto* fetch = std::get_if<PeerFetch>(&got->message)) {
                answer(*workers_[got->asker.value - 1], *fetch);
            } else {
                std::visit([&](const auto& content) { take(worker, content); }, got->message);
            }
        }
        worker.inbox.close();
    }

    void take(Worker& worker, const WorkUnit& unit) {
        const std::size_t ready_before = worker.model.ready_count();
        Messages wanted = worker.model.take(unit);
        // Runs first, so that waiting threads of this worker can start.
        offer(worker, worker.model.ready_count() - ready_before);
        put_to_master(worker, std::move(wanted));
        proceed(worker);
    }

    /// Begins the scenario whose turn has come, if scenarios take turns.
    static void proceed(Worker& worker) {
        const std::size_t ready_before = worker.model.ready_count();
        Messages wanted = worker.model.proceed();
        offer(worker, worker.model.ready_count() - ready_before);
        put_to_master(worker, std::move(wanted));
    }

    void take(Worker& worker, const Hint& hint) {
        worker.model.take(hint);
        put_to_master(worker, worker.model.ahead());
    }

    /// The threads share the opening.
    void take(Worker& worker, const Subtrees& message) {
        const std::size_t count = message.blocks.size();
        std::size_t begin = 0;
        for (std::uint32_t i = 1; i <= worker.threads; ++i) {
            const std::size_t end = count * i / worker.threads;
            if (end > begin) {
                worker.unopened.push_back({message.tree,
                                           {message.blocks.begin() + offset(begin),
                                            message.blocks.begin() + offset(end)}});
                offer(worker, 1);
            }
            begin = end;
        }
    }

    void take(Worker& worker, const FetchFromPeers& directed) {
        PeerFetch fetch;
        fetch.tree = directed.tree;
        fetch.roots = directed.roots;
        const std::uint64_t bytes = bytes_of(fetch, workload_);
        workers_[directed.sources.front().worker.value - 1]->inbox.put(
            {std::move(fetch), worker.model.id()}, bytes);
    }

    /// The source's uploads share its link.
    void answer(Worker& asker, const PeerFetch& fetch) {
        Subtrees blocks;
        blocks.tree = fetch.tree;
        for (const RootIndex root : fetch.roots) {
            blocks.blocks.push_back({root, {}, {}});
        }
        const std::uint64_t bytes = bytes_of(blocks, workload_);
        outcome_.peer_bytes += bytes;
        asker.inbox.put({std::move(blocks)}, bytes);
    }

    void take(Worker& worker, const Recall& recall) {
        if (const auto recalled = worker.model.take(recall)) {
            put_to_master(worker, {*recalled});
        }
        send_results(worker); // A task with no scenarios left ends.
    }

    void take(Worker& worker, const DropScenario& loser) {
        if (worker.model.take(loser)) {
            worker.running.at(loser.scenario)->cancel();
        }
        send_results(worker);
    }

    void take(Worker& worker, const Terminate& /*message*/) {
        worker.is_over = true;
        offer(worker, worker.threads);
        worker.finished->release();
    }

    template <class Other>
    void take(Worker& /*worker*/, const Other& /*message*/) {}

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
                const Subtrees blocks = std::move(worker.unopened.front());
                worker.unopened.pop_front();
                open(worker, blocks);
            } else if (worker.model.ready_count() != 0) { // Otherwise the scenario was returned.
                run_scenario(worker, worker.model.next(), times);
            }
        }
    }

    void open(Worker& worker, const Subtrees& blocks) {
        spend(worker.model.open_seconds(blocks));
        const std::size_t ready_before = worker.model.ready_count();
        Messages held = worker.model.opened(blocks);
        offer(worker, worker.model.ready_count() - ready_before);
        put_to_master(worker, std::move(held));
        put_to_master(worker, worker.model.ahead());
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
        proceed(worker);
    }

    void send_results(Worker& worker) {
        // A worker that waits for blocks has time to send its results.
        const double period = worker.model.ready_count() != 0
                                  ? options_.results_period
                                  : std::min(options_.results_period, idle_period());
        put(worker.model.due(s4u::Engine::get_clock(), period), worker.unpacked, *worker.finished);
    }

    /// Appends messages to a queue and counts them. The order is that of the calls, although
    /// SimGrid lets other actors run at each `release`.
    static void put(Messages messages, std::deque<Message>& queue, s4u::Semaphore& count) {
        std::ranges::move(messages, std::back_inserter(queue));
        for (std::size_t i = 0; i < messages.size(); ++i) {
            count.release();
        }
    }

    /// Packs outgoing messages on the worker's network thread.
    void run_packer(Worker& worker) {
        for (worker.finished->acquire(); !worker.is_over; worker.finished->acquire()) {
            Message message = std::move(worker.unpacked.front());
            worker.unpacked.pop_front();
            if (const auto* results = std::get_if<Results>(&message)) {
                spend(results->count * workload_.results.packing_seconds);
            }
            put_to_master(worker, {std::move(message)});
        }
    }

    /// While idle, results are kept only if they wait for their task's end anyway.
    [[nodiscard]] double idle_period() const {
        return options_.results_period == std::numeric_limits<double>::infinity()
                   ? options_.results_period
                   : 0;
    }

    static void put_to_master(Worker& worker, Messages messages) {
        put(std::move(messages), worker.untold, *worker.told);
    }

    [[nodiscard]] Outcome outcome() const {
        const MasterCounts& counts = master_.counts();
        Outcome outcome = outcome_;
        outcome.answered = master_.answered();
        outcome.answered_again = counts.results - master_.answered();
        outcome.batches = counts.batches;
        outcome.recalled = master_.recalled();
        outcome.copies = master_.copies();
        outcome.wants = counts.wants;
        outcome.blocks = counts.blocks;
        outcome.block_bytes = counts.block_bytes;
        outcome.sent_bytes = counts.sent_bytes;
        outcome.coordinator_us =
            1e6 * counts.seconds / static_cast<double>(std::max<std::size_t>(workload_.count(), 1));
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
    SimulatedMaster master_;
    Inbox<Event> to_master_;
    std::vector<std::unique_ptr<Worker>> workers_;
    bool is_over_ = false;
    s4u::SemaphorePtr work_;                   ///< Wakes the pool's threads.
    std::deque<std::size_t> entries_to_write_; ///< Number of results in each.
    std::size_t entries_offered_ = 0;          ///< Those that the journal's thread has or had.
    s4u::SemaphorePtr entries_;                ///< Counts the entries to write.
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
