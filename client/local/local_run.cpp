#include "client/local/local_run.hpp"

#include "client/local/ordered_run.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t cost_poses_max = 64;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Adds scenarios to the run while it wants more, until it is time to report progress.
Status feed(OrderedRun& run, PoseSource& poses, std::uint64_t& fed) {
    const auto end = Clock::now() + timing::progress_period;
    while (fed < poses.count() && Clock::now() < end) {
        // A grid gives many poses quickly. Other sources, such as random poses, may take long, so
        // this thread reads fewer of them before it reports progress.
        const std::uint64_t at_once =
            poses.grid() == nullptr ? limits::run_poses_at_once_max : UINT64_MAX;
        const std::uint64_t wanted = std::min(run.wanted(), at_once);
        if (wanted == 0) {
            break;
        }
        auto scenarios = CD_TRY(poses.read(fed, std::min(wanted, poses.count() - fed)));
        fed += scenarios.size();
        run.add(std::move(scenarios));
    }
    return Done{};
}

/// Passes results to the observer and the merger, in which scenario `first_index` is the first.
/// Errors: Interrupted; the observer's.
Status deliver(const DoneBlock& results,
               const RunObserver& observer,
               std::uint64_t first_index,
               ResultMerger& merger) {
    if (observer.stopped()) {
        return interrupted();
    }
    if (results.empty()) {
        return Done{};
    }
    CD_TRY(observer.results(results));
    for (std::size_t i = 0; i < results.size(); ++i) {
        const auto outcome =
            merger.add(results.first() - first_index + i, results.facts()[i], results.digests()[i]);
        CD_CHECK(outcome == ResultMerger::Outcome::Added);
    }
    return Done{};
}

/// Reads a few of a job's scenarios, evenly spread, and skips those that cannot be read and those
/// of other bodies than the first.
std::vector<Scenario> some_scenarios(PoseSource& source) {
    const std::uint64_t count = std::min(source.count(), cost_poses_max);
    std::vector<Scenario> some;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto read = source.read(source.count() / count * i, 1);
        if (!read) {
            continue;
        }
        const Scenario& next = read.value().front();
        if (some.empty() || (next.body_a == some[0].body_a && next.body_b == some[0].body_b)) {
            some.push_back(next);
        }
    }
    return some;
}

/// Returns the time limit for measuring the cost of searches, after a run of `seconds`.
Clock::duration cost_time_after(double seconds) {
    constexpr std::chrono::duration<double> most = std::chrono::milliseconds(50);
    const auto share = std::chrono::duration<double>(0.02 * seconds);
    return std::chrono::duration_cast<Clock::duration>(std::min(share, most));
}

std::optional<SearchCost>
measured_cost(const TreesByBody& trees, PoseSource& source, const SearchCostOptions& options) {
    const std::vector<Scenario> some = some_scenarios(source);
    if (some.empty()) {
        return std::nullopt;
    }
    std::vector<PosePair> poses;
    for (const Scenario& scenario : some) {
        poses.push_back(scenario.poses);
    }
    const TreeView a = trees.a_of(some.front()).view();
    const TreeView b = trees.b_of(some.front()).view();
    return measure_search_cost(a, b, poses, options);
}

} // namespace

Result<RunOutcome> run_locally(const TreesByBody& trees,
                               PoseSource& poses,
                               const Query& query,
                               ThreadPool& pool,
                               const RunObserver& observer,
                               LocalRunOptions options) {
    const auto start = Clock::now();
    auto progress_due = start;
    ResultMerger merger =
        std::move(options.done).value_or(ResultMerger(poses.count(), options.scene));
    const PairStage first_stage = options.first_stage;
    std::atomic<bool> ended = false;
    const ScenarioRunner runner(
        trees, query, first_stage, [&ended] { return ended.load(std::memory_order_relaxed); });
    std::uint64_t fed = merger.summary().merged();
    OrderedRun run(runner, ended, pool, options.first_index + fed);
    while (!merger.summary().is_complete()) {
        if (observer.stopped()) {
            return interrupted();
        }
        CD_TRY(feed(run, poses, fed));
        if (Clock::now() >= progress_due) {
            observer.progress(merger.summary(), seconds_since(start));
            progress_due = Clock::now() + timing::progress_period;
        }
        CD_TRY(deliver(run.take(timing::progress_period, fed < poses.count()),
                       observer,
                       options.first_index,
                       merger));
    }
    RunOutcome outcome{
        merger.summary(), merger.digest(), seconds_since(start), run.statistics(), {}};
    SearchCostOptions cost;
    cost.for_any = query.level == Level::Any;
    cost.first_stage = first_stage;
    cost.time_max = cost_time_after(outcome.seconds);
    outcome.cost = measured_cost(trees, poses, cost);
    return outcome;
}

} // namespace cd
