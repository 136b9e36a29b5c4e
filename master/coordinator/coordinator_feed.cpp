// Chooses the jobs' next work: analyses to start, or ranges sent without analysis.
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "master/base/mutation.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/dispatch/range_choice.hpp"

#include <algorithm>

namespace cd {

void Coordinator::feed() {
    std::vector<MasterJob*> jobs;
    std::uint64_t under_way = 0;
    for (const JobId id : jobs_.running()) {
        MasterJob& job = *jobs_.find(id);
        if (job.order == nullptr) {
            continue;
        }
        under_way += job.analyses_under_way();
        const bool is_held_back =
            awaited_.holds_back(id, Clock::now()) && !mutated(Mutation::NobodyAwaited);
        if (!retries_.any(id) && !is_held_back) {
            jobs.push_back(&job);
        }
    }
    // Round robin: start after the job that was fed last.
    std::rotate(jobs.begin(),
                std::find_if(jobs.begin(),
                             jobs.end(),
                             [&](const MasterJob* job) { return job->id > fed_last_; }),
                jobs.end());
    std::erase_if(jobs, [this](MasterJob* job) {
        if (!prefers_ranges_now(*job)) {
            take_places_back(*job);
            return false;
        }
        give_places(*job);
        // Lost scenarios are analysed even if the job prefers ranges.
        return job->todo.empty() || job->todo.front().losses.none();
    });
    for (bool any_started = true; any_started;) {
        any_started = false;
        for (MasterJob* job : jobs) {
            if (job->todo.empty() || !has_room_for_analysis(under_way)) {
                continue;
            }
            if (job->analyser == nullptr) {
                begin_analysis(*job);
            }
            const auto piece = job->todo.take(limits::analysis_block_scenarios);
            if (job->done == nullptr) {
                job->done = job->merged.marks();
            }
            job->analyser->start(piece.places, piece.losses, job->done);
            fed_last_ = job->id;
            ++under_way;
            any_started = true;
        }
    }
    if (under_way == 0) {
        act(dispatcher().input_paused());
    }
}

bool Coordinator::has_room_for_analysis(std::uint64_t under_way) const {
    // Enough blocks to keep the pool busy; more would only delay results.
    return writer_.has_room() && under_way < parts_.compute.size() + 2 &&
           open_bytes_ < limits::open_analyses_bytes_max &&
           dispatcher_.unsent() + under_way * limits::analysis_block_scenarios <
               dispatcher_.unsent_enough();
}

// ---- Ranges ---------------------------------------------------------------------------------

bool Coordinator::prefers_ranges_now(const MasterJob& job) const {
    const ClusterOptions& options = job.submit.cluster;
    if (options.claim || options.analysis == AnalysisMode::Always) {
        return false;
    }
    if (options.analysis == AnalysisMode::Never) {
        return true;
    }
    RangeCosts costs;
    costs.scenarios_left = job.merged.summary().total - job.merged.summary().merged();
    costs.analysis = job.analysis_seconds.value_or(0);
    costs.matching = job.matching_seconds.value_or(0);
    costs.work = job.work_seconds.value_or(0);
    costs.threads_master = parts_.compute.size();
    costs.threads_workers = 0;
    for (const auto& [id, worker] : workers_.all()) {
        costs.threads_workers += worker.threads;
    }
    costs.missing = dispatcher_.missing_costs(job.id);
    return prefers_ranges(costs);
}

void Coordinator::give_places(MasterJob& job) {
    while (writer_.has_room() && !job.todo.empty() && job.todo.front().losses.none() &&
           dispatcher_.places_unsent(job.id) + job.places_loading <
               dispatcher_.places_enough(job.id)) {
        const PlaceRange places = job.todo.take(limits::range_scenarios_max).places;
        if (job.order->grid() != nullptr) {
            give_unmerged(job, {places, nullptr});
            continue;
        }
        job.places_loading += places.count;
        parts_.compute.post(
            [this, executor = parts_.executor, id = job.id, order = job.order, places] {
                asio::post(executor, [this, id, places, window = order->window_of(places.first)] {
                    places_came(id, places, window);
                });
            });
    }
}

void Coordinator::places_came(JobId id,
                              const PlaceRange& places,
                              const Result<std::shared_ptr<const PoseWindow>>& window) {
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        return;
    }
    job->places_loading -= places.count;
    if (window) {
        disk_gives(*job);
        give_unmerged(*job, {places, window.value()});
    } else {
        job->todo.put_back({places});
        wait_for_disk(*job, window.error(), [](MasterJob*) {});
    }
    feed();
}

void Coordinator::give_unmerged(MasterJob& job, const GivenPlaces& given) {
    for (const PlaceRange& run : unmerged(job, given)) {
        job.given.emplace(run.first, GivenPlaces{run, given.window});
        act(dispatcher().places_given(job.id, run, job.todo.left() + job.places_loading));
    }
}

std::vector<PlaceRange> Coordinator::unmerged(const MasterJob& job, const GivenPlaces& given) {
    std::vector<PlaceRange> runs;
    for (std::uint64_t place = given.places.first; place < given.places.end(); ++place) {
        const std::uint64_t index =
            given.window == nullptr ? place : given.window->at({place, 1}).front().index;
        if (job.merged.has(index)) {
            continue;
        }
        if (runs.empty() || runs.back().end() != place) {
            runs.push_back({place, 0});
        }
        ++runs.back().count;
    }
    return runs;
}

void Coordinator::take_places_back(MasterJob& job) {
    if (dispatcher_.places_unsent(job.id) == 0) {
        return;
    }
    for (const PlaceRange& places : dispatcher_.take_places(job.id)) {
        job.todo.put_back({places});
    }
    job.given.clear();
}

void Coordinator::perform(const SendRange& action) {
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return act(dispatcher().task_ended(action.worker, action.task));
    }
    const bool is_copy = action.copy_of != TaskId{};
    const GivenPlaces given =
        is_copy ? GivenPlaces{action.places, tasks_.at(action.copy_of).content->range->window}
                : job->take_given(action.places);
    job->help.copies += is_copy ? action.places.count : 0;
    auto content = std::make_shared<TaskContent>();
    content->job = job->id;
    content->material = job->material;
    content->range = RangeContent{action.places, given.window, job->order};
    ScenarioRange range{action.task, job->id, action.places.first, action.places.count, {}};
    if (content->range->window != nullptr) {
        range.first = 0;
        range.scenarios = pack_scenarios(content->range->window->at(action.places));
    }
    RunningTask task{action.worker, std::move(content)};
    task.is_copy = is_copy;
    task.places = action.places;
    tasks_.emplace(action.task, std::move(task));
    // If the worker has left, the dispatcher knows, and the range ends.
    if (Worker* worker = workers_.find(action.worker)) {
        add_job_to(*worker, *job);
        worker->channel->send(range);
        note_work(action.worker);
    }
}

void Coordinator::perform(const RangeEnded& action) {
    const auto task = tasks_.extract(action.task);
    MasterJob* job = jobs_.find_running(action.job);
    if (task.empty() || job == nullptr || mutated(Mutation::LostRangeForgotten)) {
        return;
    }
    give_again(*job, {action.places, task.mapped().content->range->window}, action.lost_with);
}

void Coordinator::perform(const GivenBack& action) {
    const auto task = tasks_.find(action.task);
    MasterJob* job = jobs_.find_running(action.job);
    if (task == tasks_.end() || job == nullptr) {
        return;
    }
    job->help.recalled += action.scenarios + action.places.count;
    if (action.places.count == 0) {
        return;
    }
    PlaceRange& kept = *task->second.places;
    kept.count = action.places.first - kept.first;
    if (!mutated(Mutation::RecalledIsLost)) {
        give_again(*job, {action.places, task->second.content->range->window}, std::nullopt);
    }
}

void Coordinator::give_again(MasterJob& job, const GivenPlaces& ended, LostWith lost_with) {
    std::vector<PlaceRange> runs = unmerged(job, ended);
    for (const auto& [id, task] : tasks_) {
        if (task.content->job == job.id && task.places) {
            runs = without(runs, *task.places); // A speculative copy, or its original.
        }
    }
    Losses losses;
    std::vector<LostPlaces> lost;
    if (lost_with) {
        losses.add(*lost_with);
    }
    for (const PlaceRange& run : runs) {
        job.todo.put_back({run, losses});
        if (lost_with) {
            lost.push_back({run, *lost_with});
        }
    }
    write_losses(job, std::move(lost));
}

void Coordinator::perform(const ScenariosLost& action) {
    MasterJob* job = jobs_.find_running(action.job);
    if (job == nullptr) {
        return;
    }
    std::vector<LostPlaces> lost;
    for (const std::uint64_t index : action.scenarios) {
        // A scenario that was given up already has its result.
        if (const auto open = job->open.find(index); open != job->open.end()) {
            lost.push_back({{open->second->place, 1}, action.process});
        }
    }
    write_losses(*job, std::move(lost));
}

void Coordinator::write_losses(MasterJob& job, std::vector<LostPlaces> losses) {
    if (!losses.empty()) {
        AddResults add{job.id, job.results, {}, {}, {}};
        add.progress = job.progress(Clock::now());
        add.losses = std::move(losses);
        writer_.write(std::move(add));
    }
}

void Coordinator::call_off_places(const MasterJob& job, WorkerId worker, std::uint64_t scenario) {
    for (auto& [id, task] : tasks_) {
        const Worker* other = workers_.find(task.worker);
        if (task.content->job == job.id && task.places && task.worker != worker &&
            other != nullptr && task.content->range->scenario(scenario)) {
            other->channel->send(DropScenario{job.id, scenario, id});
            task.is_called_off = true;
        }
    }
}

} // namespace cd
