#include "master/jobs/feed/range_feed.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace cd {

namespace {

/// The positions of the range that have neither a result nor an analysis.
PositionSet open_positions(const MasterJob& job, const GivenRange& range) {
    const OpenAnalyses& analyses = job.work()->open;
    const auto is_open = [&](std::uint64_t position) {
        const std::uint64_t index =
            range.window == nullptr ? position : range.window->index_at(position);
        return !job.merged.has(index) && !analyses.has(position);
    };
    PositionSet open;
    const std::uint64_t end = range.positions.end();
    for (std::uint64_t position = range.positions.first; position < end; ++position) {
        const std::uint64_t first = position;
        while (position < end && is_open(position)) {
            ++position;
        }
        open.add({first, position - first});
    }
    return open;
}

} // namespace

void RangeFeed::give(MasterJob& job) {
    JobWork& work = *job.work();
    while (parts_.writer.has_room() && !work.todo.empty() && work.todo.front().losses.none() &&
           parts_.dispatch.view().positions_unsent(job.id) + work.positions_loading <
               parts_.dispatch.view().positions_enough(job.id)) {
        const PositionRange positions = work.todo.take(limits::range_scenarios_max).positions;
        if (job.run->poses->grid() != nullptr) {
            give(job, {positions, nullptr});
            continue;
        }
        work.positions_loading += positions.count;
        parts_.background.compute(
            [poses = job.run->poses, positions] { return poses->window_of(positions.first); },
            [this, id = job.id, positions](const Result<Window>& window) {
                came(id, positions, window);
            });
    }
}

void RangeFeed::came(JobId id, const PositionRange& positions, const Result<Window>& window) {
    MasterJob* job = parts_.jobs.find_running(id);
    if (job == nullptr) {
        return;
    }
    job->work()->positions_loading -= positions.count;
    if (window) {
        parts_.life.disk_gives(*job);
        give(*job, {positions, window.value()});
    } else {
        job->work()->todo.put_back({positions});
        parts_.life.wait_for_disk(*job, window.error(), [](MasterJob*) {});
    }
}

void RangeFeed::give(MasterJob& job, const GivenRange& range) {
    const JobWork& work = *job.work();
    PositionSet open = open_positions(job, range);
    // A result that came while the poses were loading may have been withdrawn since, and its
    // position given again.
    open.remove(parts_.dispatch.view().unanalysed(job.id));
    for (const PositionRange& run : open.runs()) {
        const std::uint64_t after = work.todo.left() + work.positions_loading;
        parts_.dispatch.act(parts_.dispatch->positions_given(job.id, {run, range.window}, after));
    }
}

void RangeFeed::take_back(MasterJob& job) {
    if (parts_.dispatch.view().positions_unsent(job.id) == 0) {
        return;
    }
    for (const PositionRange& positions : parts_.dispatch->take_positions(job.id)) {
        job.work()->todo.put_back({positions});
    }
}

void RangeFeed::lost(const PositionsLost& lost) {
    MasterJob* job = parts_.jobs.find_running(lost.job);
    if (job == nullptr) {
        return;
    }
    AddResults add{job->id, job->results, {}, {}, {}};
    add.progress = job->progress(parts_.jobs.now());
    Losses losses;
    losses.add(lost.process);
    for (const PositionRange& run : lost.positions.runs()) {
        add.losses.push_back({run, lost.process});
        if (!lost.is_analysed) {
            job->work()->todo.put_back({run, losses});
        }
    }
    parts_.writer.write(std::move(add));
}

// ---- Withdrawn results -------------------------------------------------------------------------

void RangeFeed::give_again(MasterJob& job, std::vector<std::uint64_t> scenarios) {
    JobWork& work = *job.work();
    if (job.run->poses->grid() != nullptr) {
        return give_again(job, nullptr, std::move(scenarios));
    }
    std::map<std::uint64_t, std::vector<std::uint64_t>> by_window;
    for (const std::uint64_t index : scenarios) {
        by_window[index / limits::order_window_scenarios].push_back(index);
    }
    for (auto& [number, indices] : by_window) {
        work.positions_loading += indices.size();
        auto came = [this, id = job.id, indices](const Result<Window>& window) {
            MasterJob* running = parts_.jobs.find_running(id);
            if (running == nullptr) {
                return;
            }
            if (window) {
                running->work()->positions_loading -= indices.size();
                parts_.life.disk_gives(*running);
                return give_again(*running, window.value(), indices);
            }
            parts_.life.wait_for_disk(*running, window.error(), [this, indices](MasterJob* again) {
                if (again != nullptr) {
                    again->work()->positions_loading -= indices.size();
                    give_again(*again, indices);
                }
            });
        };
        parts_.background.block(
            [poses = job.run->poses, first = indices.front()] { return poses->window_of(first); },
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
    // Leaves out the positions that are queued or handed out already.
    PositionSet withdrawn = PositionSet::of(std::move(scenarios));
    for (const PositionQueue::Piece& piece : job.work()->todo.pieces()) {
        withdrawn.remove(piece.positions);
    }
    withdrawn.remove(parts_.dispatch.view().unanalysed(job.id));
    for (const PositionRange& run : withdrawn.runs()) {
        job.work()->todo.put_back({run});
    }
}

} // namespace cd
