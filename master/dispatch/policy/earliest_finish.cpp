#include "master/dispatch/policy/earliest_finish.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <tuple>

namespace cd {

namespace {

/// Sums, by slot, of the scenario's blocks that each worker holds, over both trees. Leaves out
/// roots that all workers hold, since these do not affect the comparison.
class HeldSums {
  public:
    explicit HeldSums(std::size_t count)
        : bytes_64_(count, 0), blocks_(count, 0), coming_64_(count, 0) {}

    void add(const PlannedTree& tree, std::span<const WeightedRoot> roots, std::size_t workers) {
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
        needs.missing_bytes = PlannedTree::bytes_unit * (bytes_64_touched_ - bytes_64_[slot]);
        needs.missing_blocks = blocks_touched_ - blocks_[slot];
        needs.coming_bytes = PlannedTree::bytes_unit * coming_64_[slot];
    }

  private:
    std::vector<std::uint64_t> bytes_64_;
    std::vector<std::uint64_t> blocks_;
    std::vector<std::uint64_t> coming_64_;
    std::uint64_t bytes_64_touched_ = 0;
    std::uint64_t blocks_touched_ = 0;
};

double bytes_of_memory(const BlockPlan& plan, const ScenarioRoots& roots) {
    const PlannedTree& a = plan.tree(roots[0].tree);
    const PlannedTree& b = plan.tree(roots[1].tree);
    const auto memory = static_cast<double>((a.triangles_total + b.triangles_total) *
                                            limits::wide_bytes_per_triangle);
    return memory > 0 ? static_cast<double>(a.bytes_total + b.bytes_total) / memory : 0;
}

} // namespace

WorkerProxy* EarliestFinish::would_choose(const DispatchJob& /*job*/,
                                          const DispatchScenario& scenario) const {
    const WorkerPool& pool = context().pool;
    const BlockPlan& plan = context().plan;
    const std::size_t workers = pool.in_order().size();
    HeldSums sums(plan.tree(scenario.roots[0].tree).held.sum_count());
    for (const TreeRoots& side : scenario.roots) {
        sums.add(plan.tree(side.tree), side.roots, workers);
    }

    ScenarioNeeds needs;
    needs.cost_ns = scenario.weight.cost_ns;
    needs.bytes_of_memory = bytes_of_memory(plan, scenario.roots);
    const WorkerProxy* excluded = context().reserved();
    WorkerProxy* best = nullptr;
    double best_seconds = 0;
    for (WorkerProxy* proxy : pool.in_order()) {
        if (!proxy->takes_work() || proxy == excluded) {
            continue;
        }
        sums.tell(proxy->slot(), needs);
        const double seconds =
            estimate_finish(context().pace.powers_of(*proxy, plan), needs).total();
        // Ties go to the worker with the fewest scenarios, then to the smallest id.
        const std::uint64_t scenarios = proxy->scenarios();
        if (best == nullptr ||
            std::tuple(seconds, scenarios) < std::tuple(best_seconds, best->scenarios())) {
            best = proxy;
            best_seconds = seconds;
        }
    }
    return best;
}

bool EarliestFinish::is_full(const WorkerProxy& proxy, const DispatchJob& job) const {
    const ScenarioBuffer& buffer = proxy.buffers.of(job.id);
    return !buffer.scenarios.empty() && buffer.cost_ns >= proxy.batch.cost_ns();
}

bool EarliestFinish::has_room_for_task(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (proxy.is_claimed()) {
        return false;
    }
    if (proxy.tasks.left() < proxy.facts().threads) {
        return true;
    }
    return proxy.tasks.count_of(job.id) < bounds(proxy, job).tasks &&
           !ends_with_long_ones(context().queue, proxy, job);
}

std::vector<std::uint64_t> EarliestFinish::take_batch(WorkerProxy& proxy,
                                                      const DispatchJob& job) const {
    if (ends_with_long_ones(context().queue, proxy, job)) {
        proxy.buffers.sort(job.id, [&](std::uint64_t one, std::uint64_t other) {
            return job.at(one).weight.cost_ns > job.at(other).weight.cost_ns;
        });
    }
    std::vector<std::uint64_t> batch;
    ScenarioWeight sum;
    for (const std::uint64_t position : proxy.buffers.of(job.id).scenarios) {
        // The batch gets at least one scenario, whatever the estimates are.
        const bool is_enough = sum.cost_ns >= proxy.batch.cost_ns() ||
                               sum.bytes > std::uint64_t{job.options.v_kb} * 1000 ||
                               batch.size() == bounds(proxy, job).batch;
        if (is_enough && !batch.empty()) {
            break;
        }
        const ScenarioWeight& weight = job.at(position).weight;
        batch.push_back(position);
        sum.cost_ns += weight.cost_ns;
        sum.bytes += weight.bytes;
    }
    proxy.buffers.remove_first(job.id, batch.size(), sum);
    return batch;
}

std::uint64_t EarliestFinish::enough(const DispatchJob& /*job*/) const {
    double wanted_ns = 0;
    for (const WorkerProxy* proxy : context().pool.in_order()) {
        wanted_ns += 4e9 * proxy->batch.seconds() * context().pace.power_of(*proxy);
    }
    return static_cast<std::uint64_t>(std::min(wanted_ns / context().pace.mean_cost_ns(),
                                               static_cast<double>(limits::unsent_by_time_max)));
}

FinishTerms EarliestFinish::finish_on(const WorkerProxy& proxy,
                                      const DispatchJob& /*job*/,
                                      const DispatchScenario& scenario) const {
    const BlockPlan& plan = context().plan;
    ScenarioNeeds needs;
    needs.cost_ns = scenario.weight.cost_ns;
    needs.bytes_of_memory = bytes_of_memory(plan, scenario.roots);
    for (const auto& [id, roots] : scenario.roots) {
        const PlannedTree& tree = plan.tree(id);
        for (const WeightedRoot& root : roots) {
            const std::uint64_t bytes = tree.bytes_of(root.root);
            if (!tree.held.holds(proxy.slot(), root.root)) {
                needs.missing_bytes += bytes;
                ++needs.missing_blocks;
            } else if (tree.coming.holds(proxy.slot(), root.root)) {
                needs.coming_bytes += bytes;
            }
        }
    }
    return estimate_finish(context().pace.powers_of(proxy, plan), needs);
}

bool ends_with_long_ones(const WorkQueue& queue, const WorkerProxy& proxy, const DispatchJob& job) {
    return queue.nothing_comes(job) && proxy.batch.are_long();
}

} // namespace cd
