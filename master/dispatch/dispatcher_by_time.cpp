// The strategy `earliest-finish`. Each scenario goes at once to the buffer of the worker with the
// earliest estimated finish, even a busy one that holds its blocks. A worker that runs dry takes
// over scenarios it would finish earlier, transfers included. So no scenario waits longer than its
// transfer would take, and at the end of a job a slow worker gets nothing that others would finish
// earlier.
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <tuple>

namespace cd {

namespace {

constexpr std::uint64_t bytes_unit = 64; ///< Unit of `PooledTree::bytes_64`.

/// Sums, by slot, of the scenario's blocks that each worker holds, over both trees. Roots held by
/// all workers are left out, since they cancel.
class HeldSums {
  public:
    explicit HeldSums(std::size_t count)
        : bytes_64_(count, 0), blocks_(count, 0), coming_64_(count, 0) {}

    void add(const PooledTree& tree, std::span<const WeightedRoot> roots, std::size_t workers) {
        std::vector<WeightedRoot> bytes_64;
        std::vector<WeightedRoot> ones;
        std::vector<WeightedRoot> coming_64;
        bytes_64.reserve(roots.size());
        ones.reserve(roots.size());
        for (const WeightedRoot& root : roots) {
            const std::uint32_t weight = tree.bytes_64[root.root];
            if (tree.held.holders_of(root.root) < workers) {
                bytes_64.push_back({root.root, weight});
                ones.push_back({root.root, 1});
                bytes_64_touched_ += weight;
            }
            if (tree.coming.holders_of(root.root) != 0) {
                coming_64.push_back({root.root, weight});
            }
        }
        tree.held.add_held(bytes_64, bytes_64_);
        tree.held.add_held(ones, blocks_);
        tree.coming.add_held(coming_64, coming_64_);
        blocks_touched_ += ones.size();
    }

    void tell(std::uint32_t slot, ScenarioNeeds& needs) const {
        needs.missing_bytes = bytes_unit * (bytes_64_touched_ - bytes_64_[slot]);
        needs.missing_blocks = blocks_touched_ - blocks_[slot];
        needs.coming_bytes = bytes_unit * coming_64_[slot];
    }

  private:
    std::vector<std::uint64_t> bytes_64_;
    std::vector<std::uint64_t> blocks_;
    std::vector<std::uint64_t> coming_64_;
    std::uint64_t bytes_64_touched_ = 0;
    std::uint64_t blocks_touched_ = 0;
};

double bytes_of_memory(const PooledTree& a, const PooledTree& b) {
    const auto memory = static_cast<double>((a.triangles_total + b.triangles_total) *
                                            limits::wide_bytes_per_triangle);
    return memory > 0 ? static_cast<double>(a.bytes_total + b.bytes_total) / memory : 0;
}

} // namespace

double Dispatcher::State::speed_of(const WorkerProxy& proxy) const {
    return proxy.facts().weight * proxy.pace().work.value_or(general.work.value_or(1));
}

double Dispatcher::State::link_of(const WorkerProxy& proxy) const {
    return proxy.pace().bytes.value_or(general.bytes.value_or(limits::link_bytes_per_second_start));
}

double Dispatcher::State::power_of(const WorkerProxy& proxy) const {
    return speed_of(proxy) * proxy.facts().threads;
}

WorkerPowers Dispatcher::State::powers_of(const WorkerProxy& proxy) const {
    WorkerPowers powers;
    powers.speed = speed_of(proxy);
    powers.bytes_per_second = link_of(proxy);
    powers.threads = proxy.facts().threads;
    powers.backlog_ns = static_cast<double>(proxy.backlog_ns());
    powers.transfers_seconds = std::max(0.0, proxy.transfers_end() - now);
    if (proxy.facts().cache_bytes != 0) {
        const std::uint64_t used = proxy.held_triangles() * limits::wide_bytes_per_triangle;
        powers.room_bytes = proxy.facts().cache_bytes - std::min(used, proxy.facts().cache_bytes);
    }
    return powers;
}

bool Dispatcher::State::takes_by_time(const WorkerProxy& proxy) const {
    return proxy.takes_work() && &proxy != reserved();
}

WorkerProxy* Dispatcher::State::earliest(const DispatchJob& job, const DispatchScenario& scenario) {
    const PooledTree& a = pool.tree(job.a.tree);
    const PooledTree& b = pool.tree(job.b.tree);
    const std::size_t workers = pool.in_order().size();
    HeldSums sums(a.held.sum_count());
    sums.add(a, scenario.roots.a, workers);
    sums.add(b, scenario.roots.b, workers);

    ScenarioNeeds needs;
    needs.cost_ns = scenario.weight.cost_ns;
    needs.bytes_of_memory = bytes_of_memory(a, b);
    const WorkerProxy* excluded = reserved();
    WorkerProxy* best = nullptr;
    double best_seconds = 0;
    for (WorkerProxy* proxy : pool.in_order()) {
        if (!proxy->takes_work() || proxy == excluded) {
            continue;
        }
        sums.tell(proxy->slot(), needs);
        const double seconds = estimate_finish(powers_of(*proxy), needs).total();
        // Ties go to the worker with the fewest scenarios, then to the smallest id.
        const std::uint64_t scenarios = proxy->buffered() + proxy->working();
        if (best == nullptr || std::tuple(seconds, scenarios) <
                                   std::tuple(best_seconds, best->buffered() + best->working())) {
            best = proxy;
            best_seconds = seconds;
        }
    }
    return best;
}

FinishTerms Dispatcher::State::finish_on(const WorkerProxy& proxy,
                                         const DispatchJob& job,
                                         const DispatchScenario& scenario) const {
    const PooledTree& a = pool.tree(job.a.tree);
    const PooledTree& b = pool.tree(job.b.tree);
    ScenarioNeeds needs;
    needs.cost_ns = scenario.weight.cost_ns;
    needs.bytes_of_memory = bytes_of_memory(a, b);
    const auto add = [&](const PooledTree& tree, std::span<const WeightedRoot> roots) {
        for (const WeightedRoot& root : roots) {
            const std::uint64_t bytes = bytes_unit * tree.bytes_64[root.root];
            if (!tree.held.holds(proxy.slot(), root.root)) {
                needs.missing_bytes += bytes;
                ++needs.missing_blocks;
            } else if (tree.coming.holds(proxy.slot(), root.root)) {
                needs.coming_bytes += bytes;
            }
        }
    };
    add(a, scenario.roots.a);
    add(b, scenario.roots.b);
    return estimate_finish(powers_of(proxy), needs);
}

void Dispatcher::State::set_batches() {
    std::uint64_t unsent_ns = 0;
    double power = 0;
    for (const WorkerProxy* proxy : pool.in_order()) {
        unsent_ns += proxy->backlog_ns() - proxy->working_ns();
        power += proxy->takes_work() ? power_of(*proxy) : 0;
    }
    // Splits the rest into 2 W parts, proportional to speed. Before any scenario has arrived, the
    // rest is unknown.
    const double share = power > 0 && unsent_ns > 0
                             ? 1e-9 * static_cast<double>(unsent_ns) / (2 * power)
                             : limits::batch_seconds_max;
    const double mean_ns = mean_cost_ns.value_or(limits::scenario_ns_unknown);
    for (WorkerProxy* proxy : pool.in_order()) {
        const double seconds =
            std::max(std::min(proxy->batch_seconds(), share), limits::batch_seconds_min);
        proxy->set_batch_ns(static_cast<std::uint64_t>(1e9 * seconds * power_of(*proxy)));
        proxy->set_are_long(mean_ns > 1e9 * limits::scenario_seconds_long * speed_of(*proxy));
    }
}

std::uint64_t Dispatcher::State::enough_by_time() const {
    // Two batches per worker, and as many again to choose from.
    double wanted_ns = 0;
    for (const WorkerProxy* proxy : pool.in_order()) {
        wanted_ns += 4e9 * proxy->batch_seconds() * power_of(*proxy);
    }
    const double mean_ns = mean_cost_ns.value_or(limits::scenario_ns_unknown);
    return static_cast<std::uint64_t>(
        std::min(wanted_ns / mean_ns, static_cast<double>(limits::unsent_by_time_max)));
}

// At the end no scenario waits behind a long one at a busy worker: an idle worker could take it.
bool Dispatcher::State::has_room_by_time(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (proxy.is_claimed()) {
        return false;
    }
    if (proxy.working() < proxy.facts().threads) {
        return true;
    }
    return proxy.tasks_of(job.id) < limits::batches_at_worker && !ends_with_long_ones(proxy, job);
}

bool Dispatcher::State::runs_dry_by_time(const WorkerProxy& proxy) const {
    return proxy.working_ns() < proxy.batch_ns() || proxy.working() < proxy.facts().threads;
}

bool Dispatcher::State::ends_with_long_ones(const WorkerProxy& proxy,
                                            const DispatchJob& job) const {
    return input_is_paused && job.waiting.empty() && proxy.are_long();
}

std::vector<std::uint64_t> Dispatcher::State::take_batch(WorkerProxy& proxy,
                                                         const DispatchJob& job) {
    if (ends_with_long_ones(proxy, job)) {
        // Longest first, so that the workers finish together.
        proxy.order_buffer(job.id, [&](std::uint64_t one, std::uint64_t other) {
            return job.at(one).weight.cost_ns > job.at(other).weight.cost_ns;
        });
    }
    std::vector<std::uint64_t> batch;
    std::uint64_t cost_ns = 0;
    std::uint64_t bytes = 0;
    for (const std::uint64_t index : proxy.buffer(job.id).scenarios) {
        const ScenarioWeight& weight = job.at(index).weight;
        if (cost_ns >= proxy.batch_ns() || bytes > std::uint64_t{job.options.v_kb} * 1000 ||
            batch.size() == limits::q_max) {
            break;
        }
        batch.push_back(index);
        cost_ns += weight.cost_ns;
        bytes += weight.bytes;
    }
    // Take at least one scenario, whatever the estimates are.
    if (batch.empty()) {
        batch.push_back(proxy.buffer(job.id).scenarios.front());
    }
    proxy.remove_first(job.id, batch.size(), sum_of_weights(job, batch));
    return batch;
}

ScenarioWeight Dispatcher::State::sum_of_weights(const DispatchJob& job,
                                                 std::span<const std::uint64_t> scenarios) const {
    ScenarioWeight sum;
    for (const std::uint64_t index : scenarios) {
        const ScenarioWeight& weight = job.at(index).weight;
        sum.bytes += weight.bytes;
        sum.cost_ns += weight.cost_ns;
    }
    return sum;
}

void Dispatcher::State::rebalance(Actions& actions) {
    if (std::none_of(
            jobs.begin(), jobs.end(), [](const auto& job) { return job.second.is_by_time(); })) {
        return;
    }
    std::vector<Backlog> full; // Heap; latest finish on top.
    for (WorkerProxy* proxy : pool.in_order()) {
        add_backlog(full, *proxy);
    }
    for (WorkerProxy* proxy : pool.in_order()) {
        if (full.empty()) {
            return;
        }
        const bool runs_dry = proxy->buffered() == 0 && runs_dry_by_time(*proxy);
        if (runs_dry && takes_by_time(*proxy) && !proxy->is_claimed()) {
            WorkerProxy& fullest = *full.front().worker;
            std::pop_heap(full.begin(), full.end());
            full.pop_back();
            move(fullest, *proxy);
            add_backlog(full, fullest);
            flush_ripe(*proxy, actions);
            add_backlog(full, *proxy);
        }
    }
}

void Dispatcher::State::add_backlog(std::vector<Backlog>& full, WorkerProxy& proxy) const {
    const double seconds = static_cast<double>(proxy.backlog_ns()) / power_of(proxy);
    if (proxy.buffered() != 0 && seconds > 0) {
        full.push_back({seconds, &proxy});
        std::push_heap(full.begin(), full.end());
    }
}

void Dispatcher::State::move(WorkerProxy& from, WorkerProxy& to) {
    for (auto& [id, job] : jobs) {
        std::size_t tries = limits::moves_tried_max;
        while (job.is_by_time() && tries-- > 0 && to.backlog_ns() < 2 * to.batch_ns() &&
               move_one(from, to, job)) {
        }
    }
}

bool Dispatcher::State::move_one(WorkerProxy& from, WorkerProxy& to, DispatchJob& job) {
    const ScenarioBuffer& buffer = from.buffer(job.id);
    if (buffer.scenarios.empty()) {
        return false;
    }
    if (ends_with_long_ones(from, job)) {
        const auto cost = [&](std::uint64_t index) { return job.at(index).weight.cost_ns; };
        const auto longest = std::ranges::max_element(buffer.scenarios, {}, cost);
        if (move_if_earlier(from, to, job, *longest)) {
            return true;
        }
    }
    // The last scenario would finish only after everything else `from` has.
    return move_if_earlier(from, to, job, buffer.scenarios.back());
}

bool Dispatcher::State::move_if_earlier(WorkerProxy& from,
                                        WorkerProxy& to,
                                        DispatchJob& job,
                                        std::uint64_t index) {
    DispatchScenario& scenario = job.at(index);
    const double seconds_there = 1e-9 * static_cast<double>(from.backlog_ns()) / power_of(from);
    if (finish_on(to, job, scenario).total() >= seconds_there) {
        return false;
    }
    from.remove_from_buffer(job.id, index, scenario.weight);
    scenario.worker = to.id();
    hold_roots(job, scenario, to);
    to.add_to_buffer(job.id, index, scenario.weight);
    return true;
}

} // namespace cd
