#include "master/jobs/work/range_feed.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace cd {

namespace {

/// The given positions whose scenarios have no result.
std::vector<PlaceRange> unmerged(const MasterJob& job, const GivenPlaces& given) {
    PlaceRuns runs;
    for (std::uint64_t place = given.places.first; place < given.places.end(); ++place) {
        const std::uint64_t index =
            given.window == nullptr ? place : given.window->at({place, 1}).front().index;
        if (!job.merged.has(index)) {
            runs.add(place);
        }
    }
    return runs.take();
}

} // namespace

void RangeFeed::give(MasterJob& job) {
    JobWork& work = *job.work();
    while (parts_.writer.has_room() && !work.todo.empty() && work.todo.front().losses.none() &&
           parts_.dispatch.view().places_unsent(job.id) + work.places_loading <
               parts_.dispatch.view().places_enough(job.id)) {
        const PlaceRange places = work.todo.take(limits::range_scenarios_max).places;
        if (work.order->grid() != nullptr) {
            give(job, {places, nullptr});
            continue;
        }
        work.places_loading += places.count;
        parts_.background.compute(
            [order = work.order, places] { return order->window_of(places.first); },
            [this, id = job.id, places](const Result<Window>& window) {
                came(id, places, window);
            });
    }
}

void RangeFeed::came(JobId id, const PlaceRange& places, const Result<Window>& window) {
    MasterJob* job = parts_.jobs.find_running(id);
    if (job == nullptr) {
        return;
    }
    job->work()->places_loading -= places.count;
    if (window) {
        parts_.life.disk_gives(*job);
        give(*job, {places, window.value()});
    } else {
        job->work()->todo.put_back({places});
        parts_.life.wait_for_disk(*job, window.error(), [](MasterJob*) {});
    }
}

void RangeFeed::give(MasterJob& job, const GivenPlaces& given) {
    JobWork& work = *job.work();
    for (const PlaceRange& run : unmerged(job, given)) {
        work.given.add({run, given.window});
        const std::uint64_t after = work.todo.left() + work.places_loading;
        parts_.dispatch.act(parts_.dispatch->places_given(job.id, run, after));
    }
}

void RangeFeed::take_back(MasterJob& job) {
    if (parts_.dispatch.view().places_unsent(job.id) == 0) {
        return;
    }
    for (const PlaceRange& places : parts_.dispatch->take_places(job.id)) {
        job.work()->todo.put_back({places});
    }
    job.work()->given.clear();
}

// ---- What was not answered ---------------------------------------------------------------------

void RangeFeed::ended(const RangeEnded& action) {
    const auto task = parts_.tasks.take(action.task);
    MasterJob* job = parts_.jobs.find_running(action.job);
    if (!task || job == nullptr || mutated(Mutation::LostRangeForgotten)) {
        return;
    }
    requeue(*job, {action.places, task->content->range->window}, action.lost_with);
}

void RangeFeed::given_back(const GivenBack& action) {
    Lease* task = parts_.tasks.find(action.task);
    MasterJob* job = parts_.jobs.find_running(action.job);
    if (task == nullptr || job == nullptr) {
        return;
    }
    job->tally.help.recalled += action.scenarios + action.places.count;
    if (action.places.count == 0) {
        return;
    }
    task->places->count = action.places.first - task->places->first;
    if (!mutated(Mutation::RecalledIsLost)) {
        requeue(*job, {action.places, task->content->range->window}, std::nullopt);
    }
}

void RangeFeed::requeue(MasterJob& job, const GivenPlaces& ended, LostWith lost_with) {
    std::vector<PlaceRange> runs = unmerged(job, ended);
    for (const PlaceRange& in_task : parts_.tasks.places_of(job.id)) {
        runs = without(runs, in_task); // The other of original and speculative copy still runs.
    }
    Losses losses;
    std::vector<LostPlaces> lost;
    if (lost_with) {
        losses.add(*lost_with);
    }
    for (const PlaceRange& run : runs) {
        job.work()->todo.put_back({run, losses});
        if (lost_with) {
            lost.push_back({run, *lost_with});
        }
    }
    write_losses(job, std::move(lost));
}

void RangeFeed::lost(const ScenariosLost& action) {
    MasterJob* job = parts_.jobs.find_running(action.job);
    if (job == nullptr) {
        return;
    }
    std::vector<LostPlaces> lost;
    for (const std::uint64_t index : action.scenarios) {
        // A scenario that was given up has a result, so its loss need not be kept.
        if (const auto open = job->work()->open.find(index)) {
            lost.push_back({{open->place, 1}, action.process});
        }
    }
    write_losses(*job, std::move(lost));
}

void RangeFeed::write_losses(MasterJob& job, std::vector<LostPlaces> losses) {
    if (!losses.empty()) {
        AddResults add{job.id, job.results, {}, {}, {}};
        add.progress = job.progress(Clock::now());
        add.losses = std::move(losses);
        parts_.writer.write(std::move(add));
    }
}

// ---- What was withdrawn ------------------------------------------------------------------------

void RangeFeed::give_again(MasterJob& job, std::vector<std::uint64_t> scenarios) {
    JobWork& work = *job.work();
    if (work.order->grid() != nullptr) {
        return give_again(job, nullptr, std::move(scenarios));
    }
    std::map<std::uint64_t, std::vector<std::uint64_t>> by_window;
    for (const std::uint64_t index : scenarios) {
        by_window[index / limits::order_window_scenarios].push_back(index);
    }
    for (auto& [number, indices] : by_window) {
        work.places_loading += indices.size();
        auto came = [this, id = job.id, indices](const Result<Window>& window) {
            MasterJob* running = parts_.jobs.find_running(id);
            if (running == nullptr) {
                return;
            }
            if (window) {
                running->work()->places_loading -= indices.size();
                parts_.life.disk_gives(*running);
                return give_again(*running, window.value(), indices);
            }
            parts_.life.wait_for_disk(*running, window.error(), [this, indices](MasterJob* again) {
                if (again != nullptr) {
                    again->work()->places_loading -= indices.size();
                    give_again(*again, indices);
                }
            });
        };
        parts_.background.block(
            [order = work.order, first = indices.front()] { return order->window_of(first); },
            std::move(came));
    }
}

void RangeFeed::give_again(MasterJob& job,
                           const Window& window,
                           std::vector<std::uint64_t> scenarios) {
    if (window != nullptr) { // On a grid the position equals the index.
        std::ranges::transform(scenarios, scenarios.begin(), [&](std::uint64_t index) {
            return window->position_of(index);
        });
    }
    std::ranges::sort(scenarios);
    PlaceRuns places;
    for (const std::uint64_t place : scenarios) {
        places.add(place);
    }
    // Leaves out the positions that are queued or handed out already.
    std::vector<PlaceRange> runs = places.take();
    for (const PlaceQueue::Piece& piece : job.work()->todo.pieces()) {
        runs = without(runs, piece.places);
    }
    for (const PlaceRange& unsent : parts_.dispatch.view().places_of(job.id)) {
        runs = without(runs, unsent);
    }
    for (const PlaceRange& in_task : parts_.tasks.places_of(job.id)) {
        runs = without(runs, in_task);
    }
    for (const PlaceRange& run : runs) {
        job.work()->todo.put_back({run});
    }
}

} // namespace cd
