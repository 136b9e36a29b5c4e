#include "master/coordinator/growth_view.hpp"

#include <algorithm>

namespace cd {

namespace {

/// Number of scenarios of the job that have yet to be answered, by workers as far as known.
double left_of(const MasterJob& job) {
    const Summary& summary = job.merged.summary();
    const auto merged = static_cast<double>(summary.merged());
    const double left = static_cast<double>(summary.total) - merged;
    const double by_master = static_cast<double>(job.tally.answered_by_master);
    return merged > 0 ? left * std::max(0.0, 1 - by_master / merged) : left;
}

} // namespace

std::optional<WorkLeft> work_left(const JobTable& jobs, const MasterCosts& costs) {
    WorkLeft left;
    double measured = 0;
    for (const JobId id : jobs.running()) {
        const MasterJob& job = jobs.at(id);
        const JobWork* work = job.work();
        const double scenarios = left_of(job);
        const double all = static_cast<double>(job.merged.summary().total) -
                           static_cast<double>(job.merged.summary().merged());
        left.scenarios += scenarios;
        left.master_seconds += all * costs.seconds_each;
        if (work == nullptr || !work->rates.work.is_known()) {
            continue;
        }
        const double each = work->rates.work.value();
        measured += scenarios;
        left.worker_seconds += scenarios * each;
        left.longest_seconds = std::max(left.longest_seconds, each);
        if (!work->open.all().empty()) { // The master analyses the job's scenarios.
            left.pool_seconds += all * work->rates.analysis.value_or(0) / costs.pool_threads;
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
    const std::optional<WorkLeft> work = work_left(jobs, costs);
    const WorkersNow workers = dispatch.workers_now();
    return work && workers.threads > 0 ? std::optional(estimate_growth(workers, *work))
                                       : std::nullopt;
}

} // namespace cd
