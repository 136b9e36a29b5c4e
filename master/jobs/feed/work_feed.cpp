#include "master/jobs/feed/work_feed.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/range_choice.hpp"

#include <algorithm>

namespace cd {

void WorkFeed::feed() {
    Load load;
    std::vector<MasterJob*> jobs = jobs_to_feed(load);
    std::erase_if(jobs, [this](MasterJob* job) {
        if (!prefers_ranges_now(*job)) {
            parts_.ranges.take_back(*job);
            return false;
        }
        parts_.ranges.give(*job);
        // Scenarios that were lost with a worker are analysed even if the job prefers ranges.
        const PositionQueue& todo = job->work()->todo;
        return todo.empty() || todo.front().losses.none();
    });
    for (bool any_started = true; any_started;) {
        any_started = false;
        for (MasterJob* job : jobs) {
            if (job->work()->todo.empty() || !has_room_for_analysis(load)) {
                continue;
            }
            parts_.analyses.start(*job);
            fed_last_ = job->id;
            ++load.under_way;
            any_started = true;
        }
    }
    if (load.under_way == 0) {
        parts_.dispatch.act(parts_.dispatch->input_paused());
    }
}

std::vector<MasterJob*> WorkFeed::jobs_to_feed(Load& load) {
    std::vector<MasterJob*> jobs;
    for (const JobId id : parts_.jobs.running()) {
        MasterJob& job = parts_.jobs.at(id);
        if (job.work() == nullptr) {
            continue;
        }
        load.under_way += job.work()->analyses_under_way();
        load.open_bytes += job.work()->open.bytes();
        const bool is_held_back =
            parts_.awaited.holds_back(id, parts_.jobs.now()) && !mutated(Mutation::NobodyAwaited);
        if (!parts_.life.is_waiting(id) && !is_held_back) {
            jobs.push_back(&job);
        }
    }
    // Round robin: start after the job that was fed last.
    std::rotate(
        jobs.begin(),
        std::ranges::find_if(jobs, [&](const MasterJob* job) { return job->id > fed_last_; }),
        jobs.end());
    return jobs;
}

bool WorkFeed::has_room_for_analysis(const Load& load) const {
    // Enough analyses keep the pool busy; more would only delay results.
    return parts_.writer.has_room() &&
           load.under_way < parts_.background.compute_pool().size() + 2 &&
           load.open_bytes < limits::open_analyses_bytes_max &&
           wants_more(load.under_way * parts_.limits.block_scenarios);
}

bool WorkFeed::wants_more(std::uint64_t under_way) const {
    const DispatchView& dispatch = parts_.dispatch.view();
    if (parts_.limits.waiting_max == 0) {
        return dispatch.unsent() + under_way < dispatch.unsent_enough();
    }
    std::uint64_t waiting = dispatch.unsent();
    for (const WorkerId worker : dispatch.workers()) {
        waiting -= dispatch.worker_status(worker).buffered;
    }
    return waiting + under_way < parts_.limits.waiting_max;
}

bool WorkFeed::prefers_ranges_now(const MasterJob& job) const {
    const ClusterOptions& options = job.submit.cluster;
    if (options.claim || options.analysis == AnalysisMode::Always) {
        return false;
    }
    if (options.analysis == AnalysisMode::Never) {
        return true;
    }
    const JobRates& rates = job.work()->rates;
    RangeCosts costs;
    costs.scenarios_left = job.merged.summary().total - job.merged.summary().merged();
    costs.analysis = rates.analysis.value_or(0);
    costs.matching = rates.matching.value_or(0);
    costs.work = rates.work.value_or(0);
    costs.threads_master = parts_.background.compute_pool().size();
    costs.threads_workers = 0;
    for (const auto& [id, worker] : parts_.workers.all()) {
        costs.threads_workers += worker.threads;
    }
    costs.missing = parts_.dispatch.view().missing_costs(job.id);
    return prefers_ranges(costs);
}

} // namespace cd
