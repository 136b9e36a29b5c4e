#include "master/jobs/feed/analysis_feed.hpp"

#include "common/job/packed_scenarios.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace cd {

void AnalysisFeed::start(MasterJob& job) {
    JobWork& work = *job.work();
    if (work.analyser == nullptr) {
        work.analyser = make_analyser(job);
    }
    if (work.done == nullptr) {
        work.done = job.merged.marks();
    }
    const PositionQueue::Piece piece = work.todo.take(parts_.limits.block_scenarios);
    work.analyser->start(piece.positions, piece.losses, work.done);
}

std::unique_ptr<Analyser> AnalysisFeed::make_analyser(const MasterJob& job) {
    // `deliver` runs on a pool thread, so that the results are encoded there.
    auto deliver = [this, &background = parts_.background, id = job.id](AnalysedBlock block) {
        TakenResults finished;
        for (const Analysis& analysis : block.scenarios) {
            if (analysis.finished) {
                finished.add(*analysis.finished, analysis.position, analysis.cost);
            }
        }
        background.post(
            [this, id, block = std::move(block), finished = std::move(finished)]() mutable {
                came(id, std::move(block), std::move(finished));
            });
    };
    return std::make_unique<Analyser>(
        parts_.background.compute_pool(), job.work()->analysis_input, std::move(deliver));
}

void AnalysisFeed::came(JobId id, AnalysedBlock block, TakenResults finished) {
    MasterJob* job = parts_.jobs.find_running(id);
    if (job == nullptr) {
        return;
    }
    job->work()->analyser->block_taken();
    if (block.error) {
        job->work()->todo.put_back({block.positions, block.losses});
        return parts_.life.wait_for_disk(*job, *block.error, [](MasterJob*) {});
    }
    parts_.life.disk_gives(*job);
    parts_.dispatch->analysis_took(id, block.positions.count, block.seconds);
    const auto begin = parts_.jobs.now();
    const HandedOut handed_out = hand_out(*job, block);
    if (!job->is_running()) {
        return;
    }
    JobRates& rates = job->work()->rates;
    rates.analysis.add(block.seconds, static_cast<double>(block.positions.count));
    if (handed_out.scenarios != 0) {
        const double seconds = std::chrono::duration<double>(parts_.jobs.now() - begin).count();
        rates.matching.add(seconds, static_cast<double>(handed_out.scenarios));
        rates.bytes.add(handed_out.added_bytes, static_cast<double>(handed_out.scenarios));
    }
    job->tally.answered_by_master += static_cast<std::uint64_t>(
        std::ranges::count_if(finished.results.rows(), [&](const ResultRow& row) {
            return !job->merged.has(row.scenario);
        }));
    parts_.merger.merge(*job, std::move(finished), nullptr);
    parts_.life.end_if_complete(*job);
}

AnalysisFeed::HandedOut AnalysisFeed::hand_out(MasterJob& job, AnalysedBlock& block) {
    const bool is_grid = job.run->poses->grid() != nullptr; // Its ranges have no poses on the wire.
    HandedOut handed_out;
    for (Analysis& analysis : block.scenarios) {
        // A scenario that was queued again may have an answer or an analysis by now.
        if (analysis.finished || job.merged.has(analysis.scenario.index) ||
            job.work()->open.has(analysis.position)) {
            continue;
        }
        AnalysedScenario scenario{analysis.position,
                                  std::move(analysis.roots_a),
                                  std::move(analysis.roots_b),
                                  analysis.bytes,
                                  analysis.predicted_ns,
                                  block.losses,
                                  analysis.scenario.body_a,
                                  analysis.scenario.body_b};
        const std::uint64_t bytes_in_range = is_grid ? 0 : packed_bytes(analysis.scenario);
        const std::uint64_t added_bytes = analysis.bytes - std::min(analysis.bytes, bytes_in_range);
        job.work()->open.add(std::move(analysis));
        parts_.dispatch.act(parts_.dispatch->scenario_analysed(job.id, std::move(scenario)));
        if (!job.is_running()) { // The last missing scenario was given up, which ended the job.
            break;
        }
        ++handed_out.scenarios;
        handed_out.added_bytes += static_cast<double>(added_bytes);
    }
    return handed_out;
}

} // namespace cd
