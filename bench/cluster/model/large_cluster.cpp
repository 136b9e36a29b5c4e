#include "bench/cluster/model/large_cluster.hpp"

#include "bench/cluster/model/master_model.hpp"
#include "bench/cluster/model/worker_model.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <queue>
#include <utility>

namespace cd::bench {

namespace {

constexpr std::uint64_t control_bytes_max = 1u << 14;

/// Pending events, ordered by time, then by insertion.
class Agenda {
  public:
    void at(double time, std::function<void()> what) {
        entries_.push({std::max(time, now_), next_++, std::move(what)});
    }
    /// Returns false when no event is left.
    bool step() {
        if (entries_.empty()) {
            return false;
        }
        const auto what = entries_.top().what;
        now_ = entries_.top().time;
        entries_.pop();
        what();
        return true;
    }
    [[nodiscard]] double now() const { return now_; }

  private:
    struct Entry {
        double time = 0;
        std::uint64_t number = 0;
        std::function<void()> what;

        bool operator<(const Entry& other) const {
            return std::pair(time, number) > std::pair(other.time, other.number);
        }
    };
    std::priority_queue<Entry> entries_;
    std::uint64_t next_ = 0;
    double now_ = 0;
};

class LargeCluster {
  public:
    LargeCluster(const Workload& workload, const LargeOptions& options)
        : workload_(workload),
          options_(options),
          master_(workload, options.dispatch, 0, options.peers, options.cache_bytes),
          idle_analysts_(options.analysts) {
        hosts_.reserve(options.speeds.size());
        for (const double speed : options.speeds) {
            hosts_.emplace_back(
                WorkerModel(WorkerId{hosts_.size() + 1}, workload, options.cache_bytes), speed);
        }
        links_.resize(hosts_.size() + 1);
    }

    LargeOutcome run() {
        const std::vector<std::uint32_t> threads(hosts_.size(), 1);
        send(master_.start(threads));
        analyse();
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
        bool is_busy = false;
        double ends = 0;         ///< End of the running scenario.
        double opened_until = 0; ///< End of the opening of its blocks.
        double first = 0;        ///< Start of the host's first scenario.
        double last = 0;
        double worked = 0;
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

    void tell_master(std::size_t from, ToMaster message) {
        const std::uint64_t bytes = bytes_of(message, workload_);
        outcome_.received_bytes += bytes;
        agenda_.at(pass(from, 0, bytes), [this, message = std::move(message)]() mutable {
            in_.push_back(std::move(message));
            serve();
        });
    }

    // ---- The master -----------------------------------------------------------------------------

    /// Handles one message after the other.
    void serve() {
        if (is_serving_ || in_.empty()) {
            return;
        }
        is_serving_ = true;
        const ToMaster message = std::move(in_.front());
        in_.pop_front();
        const double spent_before = master_.counts().dispatcher_seconds;
        std::vector<Letter> letters = master_.time_is(agenda_.now());
        auto more = std::visit([&](const auto& content) { return master_.take(content); }, message);
        std::move(more.begin(), more.end(), std::back_inserter(letters));
        const double spent =
            options_.charges_dispatcher ? master_.counts().dispatcher_seconds - spent_before : 0;
        charged_ += spent;
        agenda_.at(agenda_.now() + spent, [this, letters = std::move(letters)]() mutable {
            send(std::move(letters));
            is_serving_ = false;
            analyse();
            serve();
        });
    }

    /// Analyses in blocks, as the real master does.
    void analyse() {
        while (idle_analysts_ != 0) {
            const auto [first, count] =
                master_.next_block_to_analyse(limits::analysis_block_scenarios);
            if (count == 0) {
                return;
            }
            --idle_analysts_;
            double seconds = 0;
            for (std::uint64_t index = first; index < first + count; ++index) {
                seconds += workload_.scenario(index).analysis_seconds;
            }
            agenda_.at(agenda_.now() + seconds, [this, first = first, count = count] {
                ++idle_analysts_;
                for (std::uint64_t index = first; index < first + count; ++index) {
                    in_.push_back(Analysed{index});
                }
                serve();
            });
        }
    }

    // ---- A host ---------------------------------------------------------------------------------

    void deliver(std::size_t to, const ToWorker& message) {
        std::visit([&](const auto& content) { take(to, content); }, message);
        work(to);
    }

    void take(std::size_t to, const BatchSent& batch) {
        if (auto wanted = host(to).model.take(batch)) {
            tell_master(to, std::move(*wanted));
        }
    }
    void take(std::size_t to, const Hinted& hint) {
        host(to).model.take(hint);
        ask_ahead(to);
    }
    void ask_ahead(std::size_t number) {
        if (auto wanted = host(number).model.ahead()) {
            tell_master(number, std::move(*wanted));
        }
    }
    /// A group of scenarios does not delay the opening of blocks: its next scenario waits.
    void take(std::size_t to, const BlocksSent& blocks) {
        Host& here = host(to);
        const double seconds = here.model.open_seconds(blocks) / here.speed;
        here.opened_until = std::max(here.opened_until, agenda_.now()) + seconds;
        here.ends += seconds;
        agenda_.at(here.opened_until, [this, to, blocks] { opened(to, blocks); });
    }
    void take(std::size_t to, const FetchDirected& directed) {
        const PeerAsked asked{host(to).model.id(), directed.blocks};
        const std::size_t source = directed.source.value;
        agenda_.at(pass(to, source, bytes_of(ToWorker(asked), workload_)),
                   [this, source, asked] { answer(source, asked); });
    }
    void take(std::size_t to, const PeerAsked& asked) { answer(to, asked); }
    void take(std::size_t to, const AskedBack& asked) {
        tell_master(to, host(to).model.take(asked));
        tell_results(to);
    }
    /// A running scenario is not stopped.
    void take(std::size_t to, const CalledOff& loser) {
        (void)host(to).model.take(loser);
        tell_results(to);
    }
    void take(std::size_t /*to*/, const Ended& /*message*/) {}

    /// Reports missing blocks, so that they are requested again.
    void answer(std::size_t source, const PeerAsked& asked) {
        BlocksSent given;
        std::vector<BlockId> missing;
        for (const BlockId& block : asked.blocks) {
            (host(source).model.has(block) ? given.blocks : missing).push_back(block);
        }
        const std::size_t to = asked.asker.value;
        if (!given.blocks.empty()) {
            const std::uint64_t bytes = bytes_of(ToWorker(given), workload_);
            outcome_.peer_bytes += bytes;
            agenda_.at(pass(source, to, bytes), [this, to, given] { deliver(to, given); });
        }
        if (!missing.empty()) {
            tell_master(to, PeerFailed{asked.asker, host(source).model.id(), missing});
            tell_master(to, BlocksWanted{asked.asker, std::move(missing)});
        }
    }

    [[nodiscard]] Host& host(std::size_t number) { return hosts_[number - 1]; }

    void work(std::size_t number) {
        Host& here = host(number);
        if (here.is_busy || here.model.ready_count() == 0) {
            return;
        }
        const std::uint64_t scenario = here.model.next();
        const double seconds = workload_.scenario(scenario).work_seconds / here.speed;
        const double begins = std::max(here.opened_until, agenda_.now());
        here.first = here.worked == 0 ? begins : here.first;
        here.is_busy = true;
        here.ends = begins + seconds;
        agenda_.at(here.ends,
                   [this, number, scenario, seconds] { ran(number, scenario, seconds); });
    }

    void opened(std::size_t number, const BlocksSent& blocks) {
        Host& here = host(number);
        if (BlocksHeld held = here.model.opened(blocks); !held.blocks.empty()) {
            tell_master(number, std::move(held));
        }
        ask_ahead(number);
        tell_evicted(number);
        work(number);
    }

    void ran(std::size_t number, std::uint64_t scenario, double seconds) {
        Host& here = host(number);
        if (here.ends > agenda_.now()) { // Opening blocks delayed the scenario.
            agenda_.at(here.ends,
                       [this, number, scenario, seconds] { ran(number, scenario, seconds); });
            return;
        }
        here.is_busy = false;
        here.worked += seconds;
        here.last = agenda_.now();
        here.model.ran(scenario, agenda_.now(), seconds);
        tell_results(number);
        tell_evicted(number);
        work(number);
    }

    void tell_results(std::size_t number) {
        Host& here = host(number);
        const double period = here.model.ready_count() != 0 ? options_.results_period : 0;
        for (ResultsSent& results : here.model.due(agenda_.now(), period)) {
            tell_master(number, std::move(results));
        }
    }

    void tell_evicted(std::size_t number) {
        if (auto evicted = host(number).model.evicted()) {
            outcome_.evictions += evicted->blocks.size();
            tell_master(number, std::move(*evicted));
        }
    }

    [[nodiscard]] LargeOutcome outcome() const {
        const MasterCounts& counts = master_.counts();
        LargeOutcome outcome = outcome_;
        outcome.seconds = agenda_.now();
        outcome.answered = counts.answered;
        outcome.sent_bytes = counts.sent_bytes;
        outcome.block_bytes = counts.block_bytes;
        outcome.dispatcher_us =
            1e6 * counts.dispatcher_seconds / static_cast<double>(workload_.count());
        outcome.master_share = charged_ / outcome.seconds;
        double all = 0;
        for (const Host& host : hosts_) {
            all += host.speed * outcome.seconds;
        }
        for (const Host& host : hosts_) {
            const bool worked = host.worked > 0;
            const double first = worked ? host.first : outcome.seconds;
            const double last = worked ? host.last : outcome.seconds;
            outcome.start_share += host.speed * first / all;
            outcome.between_share += host.speed * (last - first - host.worked) / all;
            outcome.tail_share += host.speed * (outcome.seconds - last) / all;
        }
        return outcome;
    }

    const Workload& workload_;
    const LargeOptions& options_;
    MasterModel master_;
    std::vector<Host> hosts_;
    std::vector<Link> links_;
    Agenda agenda_;
    std::deque<ToMaster> in_;
    bool is_serving_ = false;
    std::uint32_t idle_analysts_ = 0;
    double charged_ = 0;
    LargeOutcome outcome_;
};

} // namespace

LargeOutcome simulate_large(const Workload& workload, const LargeOptions& options) {
    return LargeCluster(workload, options).run();
}

} // namespace cd::bench
