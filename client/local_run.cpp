#include "client/local_run.hpp"

#include "client/ordered_run.hpp"
#include "common/core/check.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds progress_period{100};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Error interrupted() {
    return {ErrorCode::Interrupted, "interrupted; no results were kept"};
}

/// Hands the next scenarios to the run while it wants them.
Status feed(OrderedRun& run, PoseSource& poses, std::uint64_t& fed) {
    while (fed < poses.count()) {
        const std::uint64_t wanted = run.wanted();
        if (wanted == 0) {
            break;
        }
        auto scenarios = poses.read(fed, std::min(wanted, poses.count() - fed));
        if (!scenarios) {
            return scenarios.error();
        }
        fed += scenarios.value().size();
        run.add(std::move(scenarios.value()));
    }
    return Done{};
}

/// Hands results to the observer and to the merger.
Status
deliver(std::vector<DoneScenario> results, const RunObserver& observer, ResultMerger& merger) {
    for (const DoneScenario& done : results) {
        if (observer.stopped()) {
            return interrupted();
        }
        if (Status added = observer.result(done.result); !added) {
            return added;
        }
        const auto outcome = merger.add(done.result, done.digest);
        CD_CHECK(outcome == ResultMerger::Outcome::Added);
    }
    return Done{};
}

} // namespace

Result<RunOutcome> run_locally(const ObbTree& a,
                               const ObbTree& b,
                               PoseSource& poses,
                               const Query& query,
                               ThreadPool& pool,
                               const RunObserver& observer,
                               PairStage first_stage) {
    const auto start = Clock::now();
    auto progress_due = start;
    ResultMerger merger(poses.count());
    std::atomic<bool> ended = false;
    const ScenarioRunner runner(
        a, b, query, first_stage, [&ended] { return ended.load(std::memory_order_relaxed); });
    OrderedRun run(runner, ended, pool);
    std::uint64_t fed = 0;
    while (!merger.summary().is_complete()) {
        if (observer.stopped()) {
            return interrupted();
        }
        if (Status more = feed(run, poses, fed); !more) {
            return more.error();
        }
        if (Clock::now() >= progress_due) {
            observer.progress(merger.summary(), seconds_since(start));
            progress_due = Clock::now() + progress_period;
        }
        auto results = run.take(progress_period, fed < poses.count());
        if (Status delivered = deliver(std::move(results), observer, merger); !delivered) {
            return delivered.error();
        }
    }
    return RunOutcome{merger.summary(), merger.digest(), seconds_since(start), run.statistics()};
}

} // namespace cd
