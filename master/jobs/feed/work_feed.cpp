#include "master/jobs/feed/work_feed.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/range_choice.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void WorkFeed::feed() {
    Load load;
    const Jobs all = jobs_to_feed(load);
    Jobs jobs = all;
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
    std::uint64_t count = 0; // Jobs of this or a higher priority.
    for (std::span<MasterJob* const> rest(jobs); !rest.empty();) {
        const std::int32_t priority = rest.front()->submit.priority;
        const auto lower = std::ranges::find_if(
            rest, [&](const MasterJob* job) { return job->submit.priority != priority; });
        const auto alike = static_cast<std::size_t>(lower - rest.begin());
        count += alike;
        analyse(rest.first(alike), parts_.dispatch.view().unsent_enough() / count, load);
        rest = rest.subspan(alike);
    }
    if (load.under_way == 0) {
        parts_.dispatch.act(parts_.dispatch->input_paused());
    } else {
        for (const MasterJob* job : all) {
            if (job->work() != nullptr && job->work()->analyses_under_way() == 0) {
                parts_.dispatch.act(parts_.dispatch->job_input_paused(job->id));
            }
        }
    }
    look_again(all);
}

void WorkFeed::look_again(const Jobs& jobs) {
    const bool some_wait = std::ranges::any_of(jobs, [this](const MasterJob* job) {
        return job->work() != nullptr && parts_.dispatch.view().positions_unsent(job->id) != 0;
    });
    if (!some_wait || std::exchange(looks_again_, true)) {
        return;
    }
    parts_.loop.after(timing::end_check_period, [this] {
        looks_again_ = false;
        const DispatchView& dispatch = parts_.dispatch.view();
        const bool some_idle = std::ranges::any_of(dispatch.workers(), [&](WorkerId worker) {
            return dispatch.worker_status(worker).working == 0;
        });
        if (some_idle) {
            return feed();
        }
        Load load;
        look_again(jobs_to_feed(load));
    });
}

void WorkFeed::analyse(std::span<MasterJob* const> jobs, std::uint64_t unsent_max, Load& load) {
    for (bool any_started = true; any_started;) {
        any_started = false;
        for (MasterJob* job : jobs) {
            if (!job->work()->todo.empty() && has_room_for_analysis(load) &&
                wants_more(*job, unsent_max, load)) {
                parts_.analyses.start(*job);
                ++load.under_way;
                any_started = true;
            }
        }
    }
}

WorkFeed::Jobs WorkFeed::jobs_to_feed(Load& load) {
    Jobs jobs;
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
    std::ranges::sort(jobs, [this](const MasterJob* one, const MasterJob* other) {
        return parts_.dispatch.view().is_analysed_before(one->id, other->id);
    });
    return jobs;
}

bool WorkFeed::has_room_for_analysis(const Load& load) const {
    // Enough analyses keep the pool busy; more would only delay results.
    return parts_.writer.has_room() &&
           load.under_way < parts_.background.compute_pool().size() + 2 &&
           load.open_bytes < limits::open_analyses_bytes_max;
}

bool WorkFeed::wants_more(const MasterJob& job, std::uint64_t unsent_max, const Load& load) const {
    const DispatchView& dispatch = parts_.dispatch.view();
    const std::uint64_t block = parts_.limits.block_scenarios;
    if (parts_.limits.waiting_max == 0) {
        return dispatch.unsent_of(job.id) + job.work()->analyses_under_way() * block < unsent_max;
    }
    std::uint64_t waiting = dispatch.unsent();
    for (const WorkerId worker : dispatch.workers()) {
        waiting -= dispatch.worker_status(worker).buffered;
    }
    return waiting + load.under_way * block < parts_.limits.waiting_max;
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
    costs.analysed_bytes = rates.bytes.value_or(0);
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
