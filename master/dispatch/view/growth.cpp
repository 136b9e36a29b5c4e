#include "master/dispatch/view/growth.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "master/dispatch/dispatch_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace cd {

namespace {

/// A new worker starts its first scenarios after this part of the time to fetch all blocks. Each
/// doubling of the number of workers adds another part, because blocks spread from worker to
/// worker. Fitted to simulated clusters (tests/bench/cluster/model/growth_test.cpp).
constexpr double fetch_part_before_work = 0.25;
constexpr double fetch_part_of_doubling = 0.25;

/// Speed of the worker's threads together, in units that all workers share: at ranges if the first
/// job sends these, else at analysed work.
double power_of(const DispatchParts& parts, const WorkerProxy& proxy) {
    for (const auto& [id, job] : parts.queue.jobs()) {
        if (!job.unsent.is_empty()) {
            return parts.pace.positions_per_second(proxy, job);
        }
    }
    return parts.pace.power_of(proxy);
}

/// Time in which the worker would receive the blocks that it holds of the open jobs' trees, s.
double fetch_seconds(const DispatchParts& parts, const WorkerProxy& proxy) {
    std::set<TreeId> trees;
    for (const auto& [id, job] : parts.queue.jobs()) {
        for (const auto& tree : job.trees.distinct()) {
            trees.insert(tree->tree);
        }
    }
    double seconds = 0;
    for (const TreeId id : trees) {
        const PlannedTree& tree = parts.plan.tree(id);
        const double held = tree.held.roots_of(proxy.slot());
        const double share = held / std::max<double>(1, tree.held.root_count());
        seconds += share * static_cast<double>(tree.bytes_total) / parts.pace.link_of(proxy) +
                   held * timing::block_seconds;
    }
    return seconds;
}

} // namespace

WorkersNow workers_now(const DispatchParts& parts) {
    WorkersNow now;
    std::vector<double> powers;
    double power = 0;
    for (const WorkerProxy* proxy : parts.pool.in_order()) {
        if (proxy->takes_work()) {
            ++now.workers;
            now.threads += proxy->facts().threads;
            now.fetch_seconds += fetch_seconds(parts, *proxy);
            powers.push_back(power_of(parts, *proxy));
            power += powers.back();
        }
    }
    if (powers.empty()) {
        return now;
    }
    now.fetch_seconds /= now.workers;
    const auto median = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::ranges::nth_element(powers, median);
    now.threads_more = *median * now.threads / power;
    return now;
}

double seconds_left(const WorkersNow& workers, const WorkLeft& work, std::uint32_t more) {
    // A scenario occupies one thread.
    const double threads_max = std::max(1.0, work.scenarios);
    const double new_threads = more * workers.threads_more;
    const double alone = work.worker_seconds / std::min(workers.threads, threads_max);
    const double doublings = std::log2(1 + more / workers.workers);
    const double fetch =
        workers.fetch_seconds * (fetch_part_before_work + fetch_part_of_doubling * doublings);
    const double together = (work.worker_seconds + new_threads * fetch) /
                            std::min(workers.threads + new_threads, threads_max);
    const double of_workers = more == 0 || together < fetch ? alone : std::min(alone, together);
    return std::max({of_workers, work.pool_seconds, work.master_seconds}) + work.tail_seconds;
}

Growth estimate_growth(const WorkersNow& workers, const WorkLeft& work) {
    Growth growth;
    growth.seconds = seconds_left(workers, work, 0);
    growth.worth.seconds = growth.seconds;
    for (std::uint32_t more = 1; more <= limits::growth_workers_max; ++more) {
        const double seconds = seconds_left(workers, work, more);
        if ((more & (more - 1)) == 0) {
            growth.more.push_back({more, seconds});
        }
        const double share = more * workers.threads_more / workers.threads;
        if (growth.seconds / seconds - 1 >= limits::growth_share_min * share) {
            growth.worth = {more, seconds};
        }
    }
    return growth;
}

} // namespace cd
