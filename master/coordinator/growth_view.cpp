#include "master/coordinator/growth_view.hpp"

#include <algorithm>

namespace cd {

namespace {

/// Scenarios of a job, answered so far or left.
struct Counts {
    double by_workers = 0;  ///< Answered by workers.
    double left = 0;        ///< Not answered.
    double for_workers = 0; ///< Left, without those that the master will answer, as far as known.
};

Counts counts_of(const MasterJob& job) {
    const Summary& summary = job.merged.summary();
    const auto merged = static_cast<double>(summary.merged());
    Counts counts;
    counts.by_workers = std::max(0.0, merged - static_cast<double>(job.tally.answered_by_master));
    counts.left = static_cast<double>(summary.total) - merged;
    counts.for_workers = merged > 0 ? counts.left * counts.by_workers / merged : counts.left;
    return counts;
}

} // namespace

std::optional<WorkLeft>
work_left(const JobTable& jobs, const DispatchView& dispatch, const MasterCosts& costs) {
    WorkLeft left;
    double measured = 0;
    for (const JobId id : jobs.running()) {
        const MasterJob& job = jobs.at(id);
        const JobWork* work = job.work();
        const Counts counts = counts_of(job);
        left.scenarios += counts.for_workers;
        left.master_seconds += counts.left * costs.seconds_each;
        if (work == nullptr || !(counts.by_workers > 0)) {
            continue;
        }
        const double each = job.tally.compute_seconds / counts.by_workers;
        const bool is_analysed = !work->open.all().empty();
        measured += counts.for_workers;
        left.worker_seconds += counts.for_workers * each;
        // Without work that moves, a worker may begin a batch when the others end.
        const double tail =
            is_analysed && !dispatch.moves_work(id) ? job.submit.cluster.q * each : each / 2;
        left.tail_seconds = std::max(left.tail_seconds, tail);
        if (is_analysed) {
            left.pool_seconds +=
                counts.left * work->rates.analysis.value_or(0) / costs.pool_threads;
        }
    }
    if (!(measured > 0) || !(left.worker_seconds > 0)) {
        return std::nullopt;
    }
    left.worker_seconds *= left.scenarios / measured;
    return left;
}

std::optional<Growth>
growth_of(const JobTable& jobs, const DispatchView& dispatch, const MasterCosts& costs) {
    const std::optional<WorkLeft> work = work_left(jobs, dispatch, costs);
    const WorkersNow workers = dispatch.workers_now();
    return work && workers.threads > 0 ? std::optional(estimate_growth(workers, *work))
                                       : std::nullopt;
}

} // namespace cd
