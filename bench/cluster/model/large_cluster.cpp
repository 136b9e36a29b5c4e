#include "bench/cluster/model/large_cluster.hpp"

#include "bench/cluster/model/agenda.hpp"
#include "bench/cluster/model/simulated_master.hpp"
#include "bench/cluster/model/worker_model.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace cd::bench {

namespace {

constexpr std::uint64_t control_bytes_max = 1u << 14;

class LargeCluster {
  public:
    LargeCluster(const Workload& workload, const LargeOptions& options)
        : workload_(workload),
          options_(options),
          master_(workload, master_options(options)),
          idle_analysts_(options.analysts) {
        hosts_.reserve(options.speeds.size() + options.late.speeds.size());
        for (const auto* speeds : {&options.speeds, &options.late.speeds}) {
            for (const double speed : *speeds) {
                hosts_.emplace_back(
                    WorkerModel(WorkerId{hosts_.size() + 1}, workload, options.cache_bytes), speed);
            }
        }
        links_.resize(hosts_.size() + 1);
    }

    LargeOutcome run() {
        const std::vector<std::uint32_t> threads(options_.speeds.size(), options_.threads);
        send(master_.start(threads));
        work_on_pool();
        await_timer();
        while (!master_.is_done() && agenda_.step()) {
        }
        return outcome();
    }

  private:
    struct Host {
        Host(WorkerModel worker, double against_fast)
            : model(std::move(worker)), speed(against_fast) {}

        WorkerModel model;
        double speed = 1;
        std::uint32_t busy = 0;  ///< Number of threads that run scenarios.
        double delay = 0;        ///< Time for which opening blocks has stopped the threads.
        double opened_until = 0; ///< End of the opening of its blocks.
        double first = 0;        ///< Start of the host's first scenario.
        double last = 0;
        double worked = 0;
        std::map<TreeId, std::set<RootIndex>> held; ///< Arrived blocks not yet reported.
        bool tells_held = false;
        bool tells_later = false; ///< Results wait for others.
    };
    /// Times until which each direction is busy, and arrivals of the last messages from and to the
    /// master: messages between two hosts stay in order.
    struct Link {
        double up = 0;
        double down = 0;
        double heard = 0;
        double told = 0;
    };

    // ---- The network ----------------------------------------------------------------------------

    /// Host 0 is the master. Returns the arrival time.
    double pass(std::size_t from, std::size_t to, std::uint64_t bytes) {
        const double now = agenda_.now();
        const double seconds = static_cast<double>(bytes) / options_.bytes_per_second;
        double& up = links_[from].up;
        double& down = links_[to].down;
        up = std::max(up, now) + seconds;
        const bool is_control = bytes <= control_bytes_max;
        down = std::max(down, is_control ? now : up - seconds) + seconds;
        double there = is_control ? now + seconds : std::max(up, down);
        there += 2 * options_.latency_seconds;
        if (from == 0) {
            there = links_[to].heard = std::max(there, links_[to].heard);
        } else if (to == 0) {
            there = links_[from].told = std::max(there, links_[from].told);
        }
        return there;
    }

    void send(std::vector<Letter> letters) {
        for (Letter& letter : letters) {
            const std::size_t to = letter.to.value;
            agenda_.at(pass(0, to, letter.bytes),
                       [this, to, content = std::move(letter.content)] { deliver(to, content); });
        }
    }

    void tell_master(std::size_t from, Messages messages) {
        for (Message& message : messages) {
            const std::uint64_t bytes = bytes_of(message, workload_);
            outcome_.received_bytes += bytes;
            agenda_.at(pass(from, 0, bytes), [this, from, message = std::move(message)] {
                add_event([this, from, message] { return master_.take(WorkerId{from}, message); });
            });
        }
    }

    // ---- The master -----------------------------------------------------------------------------

    using Letters = SimulatedMaster::Letters;

    static MasterOptions master_options(const LargeOptions& options) {
        MasterOptions master;
        master.dispatch = options.dispatch;
        master.analysis = options.analysis;
        master.peers = options.peers;
        master.cache_bytes = options.cache_bytes;
        master.pool_threads = options.analysts;
        master.result_seconds = options.result_seconds;
        return master;
    }

    void add_event(std::function<Letters()> event) {
        in_.push_back(std::move(event));
        serve();
    }

    /// Handles one event after the other. The journal takes no time.
    void serve() {
        if (is_serving_ || in_.empty()) {
            return;
        }
        is_serving_ = true;
        const auto event = std::move(in_.front());
        in_.pop_front();
        const double spent_before = master_.counts().seconds;
        const std::uint64_t results_before = master_.counts().results;
        Letters letters = master_.time_is(agenda_.now());
        const auto append = [&](Letters more) {
            std::move(more.begin(), more.end(), std::back_inserter(letters));
        };
        append(event());
        while (!master_.uncommitted().empty()) {
            append(master_.commit());
        }
        append(join_late_hosts());
        const double spent =
            (options_.charges_coordinator ? master_.counts().seconds - spent_before : 0) +
            options_.result_seconds *
                static_cast<double>(master_.counts().results - results_before);
        charged_ += spent;
        agenda_.at(agenda_.now() + spent, [this, letters = std::move(letters)]() mutable {
            send(std::move(letters));
            is_serving_ = false;
            work_on_pool();
            await_timer();
            serve();
        });
    }

    Letters join_late_hosts() {
        const double share =
            static_cast<double>(master_.answered()) / static_cast<double>(workload_.count());
        if (are_late_here_ || share < options_.late.share) {
            return {};
        }
        are_late_here_ = true;
        outcome_.joined_seconds = agenda_.now();
        outcome_.growth = master_.growth();
        const std::vector<std::uint32_t> threads(options_.late.speeds.size(), options_.threads);
        return master_.join(threads);
    }

    void work_on_pool() {
        while (idle_analysts_ != 0 && master_.has_pool_work()) {
            --idle_analysts_;
            SimulatedMaster::PoolRun run = master_.start_pool_work();
            agenda_.at(agenda_.now() + run.seconds, [this, run = std::move(run)] {
                ++idle_analysts_;
                add_event([this, run] { return master_.take(run); });
                work_on_pool();
            });
        }
    }

    void await_timer() {
        const auto next = master_.next_timer();
        if (next && (*next < timer_ || timer_ <= agenda_.now())) {
            timer_ = *next;
            agenda_.at(timer_, [this] { add_event([] { return Letters(); }); });
        }
    }

    // ---- A host ---------------------------------------------------------------------------------

    void deliver(std::size_t to, const Message& message) {
        std::visit([&](const auto& content) { take(to, content); }, message);
        work(to);
    }

    void take(std::size_t to, const WorkUnit& unit) { tell_master(to, host(to).model.take(unit)); }
    void take(std::size_t to, const Hint& hint) {
        host(to).model.take(hint);
        tell_master(to, host(to).model.ahead());
    }
    /// A group of scenarios does not delay the opening of blocks: its next scenario waits. The
    /// threads share the opening.
    void take(std::size_t to, const Subtrees& blocks) {
        Host& here = host(to);
        const double seconds = here.model.open_seconds(blocks) / here.speed / options_.threads;
        here.opened_until = std::max(here.opened_until, agenda_.now()) + seconds;
        here.delay += seconds;
        agenda_.at(here.opened_until, [this, to, blocks] { opened(to, blocks); });
    }
    void take(std::size_t to, const FetchFromPeers& directed) {
        PeerFetch fetch;
        fetch.tree = directed.tree;
        fetch.roots = directed.roots;
        const std::size_t source = directed.sources.front().worker.value;
        agenda_.at(pass(to, source, bytes_of(fetch, workload_)),
                   [this, source, to, fetch] { answer(source, to, fetch); });
    }
    void take(std::size_t to, const Recall& recall) {
        if (const auto recalled = host(to).model.take(recall)) {
            tell_master(to, {*recalled});
        }
        tell_results(to);
    }
    /// A running scenario is not stopped.
    void take(std::size_t to, const DropScenario& loser) {
        (void)host(to).model.take(loser);
        tell_results(to);
    }
    template <class Other>
    void take(std::size_t /*to*/, const Other& /*message*/) {}

    /// Reports missing blocks, so that they are requested again.
    void answer(std::size_t source, std::size_t to, const PeerFetch& fetch) {
        Subtrees given;
        given.tree = fetch.tree;
        std::vector<RootIndex> missing;
        for (const RootIndex root : fetch.roots) {
            if (host(source).model.has(block_id(fetch.tree, root))) {
                given.blocks.push_back({root, {}, {}});
            } else {
                missing.push_back(root);
            }
        }
        if (!given.blocks.empty()) {
            const std::uint64_t bytes = bytes_of(given, workload_);
            outcome_.peer_bytes += bytes;
            agenda_.at(pass(source, to, bytes), [this, to, given] { deliver(to, given); });
        }
        if (!missing.empty()) {
            tell_master(to,
                        {FetchFailed{fetch.tree, missing, WorkerId{source}, PeerOutcome::Missing},
                         WantSubtrees{fetch.tree, missing}});
        }
    }

    [[nodiscard]] Host& host(std::size_t number) { return hosts_[number - 1]; }

    /// What a thread runs without a pause.
    struct Running {
        std::vector<std::uint64_t> scenarios;
        std::vector<double> seconds;
        double delay = 0; ///< The host's when the end was computed.
    };

    void work(std::size_t number) {
        Host& here = host(number);
        while (here.busy < options_.threads && here.model.ready_count() != 0) {
            Running running;
            double seconds = 0;
            do {
                running.scenarios.push_back(here.model.next());
                const ScenarioCost& cost = workload_.scenario(running.scenarios.back());
                running.seconds.push_back(cost.work_seconds / here.speed);
                seconds += running.seconds.back();
            } while (seconds < options_.at_once_seconds && here.model.ready_count() != 0);
            const double begins = std::max(here.opened_until, agenda_.now());
            here.first = here.worked == 0 && here.busy == 0 ? begins : here.first;
            ++here.busy;
            running.delay = here.delay;
            agenda_.at(begins + seconds, [this, number, running = std::move(running)]() mutable {
                ran(number, std::move(running));
            });
        }
    }

    void opened(std::size_t number, const Subtrees& blocks) {
        tell_opened(number, host(number).model.opened(blocks));
        tell_master(number, host(number).model.ahead());
        tell_evicted(number);
        work(number);
    }

    /// Passes on what follows from the opening of blocks. Blocks that arrive within a short time
    /// are reported together, as by a worker.
    void tell_opened(std::size_t number, Messages messages) {
        Host& here = host(number);
        const auto waits = [&](const Message& message) {
            const auto* held = std::get_if<Held>(&message);
            if (held != nullptr) {
                here.held[held->tree].insert(held->roots.begin(), held->roots.end());
            }
            return held != nullptr;
        };
        std::erase_if(messages, waits);
        tell_master(number, std::move(messages));
        if (here.held.empty() || std::exchange(here.tells_held, true)) {
            return;
        }
        const double wait = here.model.results_wait() / timing::held_waits_per_results_wait;
        agenda_.at(agenda_.now() + wait, [this, number] {
            host(number).tells_held = false;
            Messages reports;
            for (const auto& [tree, roots] : std::exchange(host(number).held, {})) {
                reports.emplace_back(Held{tree, {roots.begin(), roots.end()}});
            }
            tell_master(number, std::move(reports));
        });
    }

    void ran(std::size_t number, Running running) {
        Host& here = host(number);
        if (here.delay > running.delay) { // Opening blocks delayed the scenarios.
            const double ends = agenda_.now() + here.delay - running.delay;
            running.delay = here.delay;
            agenda_.at(ends, [this, number, running = std::move(running)]() mutable {
                ran(number, std::move(running));
            });
            return;
        }
        --here.busy;
        here.last = agenda_.now();
        for (std::size_t i = 0; i < running.scenarios.size(); ++i) {
            here.worked += running.seconds[i];
            here.model.ran(running.scenarios[i], agenda_.now(), running.seconds[i]);
        }
        tell_results(number);
        tell_evicted(number);
        work(number);
    }

    void tell_results(std::size_t number) {
        constexpr auto idle = std::chrono::duration<double>(timing::results_wait_idle);
        Host& here = host(number);
        const double period = here.model.ready_count() != 0
                                  ? here.model.results_wait()
                                  : std::min(here.model.results_wait(), idle.count());
        tell_master(number, here.model.due(agenda_.now(), period));
        if (here.model.has_unsent() && !std::exchange(here.tells_later, true)) {
            agenda_.at(agenda_.now() + period, [this, number] {
                host(number).tells_later = false;
                tell_results(number);
            });
        }
    }

    void tell_evicted(std::size_t number) {
        Messages evicted = host(number).model.evicted();
        for (const Message& message : evicted) {
            outcome_.evictions += std::get<Evicted>(message).roots.size();
        }
        tell_master(number, std::move(evicted));
    }

    [[nodiscard]] LargeOutcome outcome() const {
        const MasterCounts& counts = master_.counts();
        LargeOutcome outcome = outcome_;
        outcome.seconds = agenda_.now();
        outcome.answered = master_.answered();
        outcome.sent_bytes = counts.sent_bytes;
        outcome.block_bytes = counts.block_bytes;
        outcome.uploads_max = counts.uploads_max;
        outcome.coordinator_us = 1e6 * counts.seconds / static_cast<double>(workload_.count());
        outcome.master_share = charged_ / outcome.seconds;
        double all = 0;
        for (const Host& host : hosts_) {
            all += host.speed * options_.threads * outcome.seconds;
        }
        for (const Host& host : hosts_) {
            outcome.blocks_again += host.model.blocks_again();
            const bool worked = host.worked > 0;
            const double first = worked ? host.first : outcome.seconds;
            const double last = worked ? host.last : outcome.seconds;
            const double power = host.speed * options_.threads;
            outcome.start_share += power * first / all;
            outcome.between_share += (power * (last - first) - host.speed * host.worked) / all;
            outcome.tail_share += power * (outcome.seconds - last) / all;
        }
        return outcome;
    }

    const Workload& workload_;
    const LargeOptions& options_;
    SimulatedMaster master_;
    std::vector<Host> hosts_;
    std::vector<Link> links_;
    Agenda agenda_;
    std::deque<std::function<Letters()>> in_; ///< Events that the master has yet to handle.
    double timer_ = 0; ///< Time of the last event that was scheduled for a timer.
    bool is_serving_ = false;
    bool are_late_here_ = false;
    std::uint32_t idle_analysts_ = 0;
    double charged_ = 0;
    LargeOutcome outcome_;
};

} // namespace

LargeOutcome simulate_large(const Workload& workload, const LargeOptions& options) {
    return LargeCluster(workload, options).run();
}

} // namespace cd::bench
