#include "master/jobs/job_merger.hpp"

#include "common/core/host/log.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/mutation.hpp"
#include "master/compute/record_size.hpp"

#include <utility>
#include <vector>

namespace cd {

namespace {

/// Records the dispute in the job and in `add`. Once the record is durable, the master's own result
/// decides the dispute.
Dispute open_dispute(MasterJob& job, Dispute dispute, AddResults& add) {
    log_error("results differ: job={} scenario={} worker={}",
              job.id.value,
              dispute.scenario,
              dispute.second->worker.value);
    ++job.run->disputes;
    add.remarks.push_back(
        {Remark::Kind::Disputed, dispute.scenario, dispute.digest, dispute.second->process});
    return dispute;
}

} // namespace

void JobMerger::merge(MasterJob& job,
                      TakenResults taken,
                      const std::shared_ptr<const Author>& author) {
    for (const ResultRow& row : taken.results.rows()) {
        if (const Status fits = check_record_size(row.scenario, row.length); !fits) {
            return life_.end(job, JobState::Failed, fits.error().detail);
        }
    }
    AddResults add{job.id, job.results, {}, {}, {}};
    add.author = author == nullptr ? 0 : author->process;
    job.tally.statistics += taken.cost;
    const std::vector<Dispute> disputes = merge_into(job, taken, author, add);
    meter_.count(add.results.size());
    if (!add.results.is_empty() || !add.remarks.empty()) {
        ++job.changes;
        add.progress = job.progress(life_.now());
        if (!add.results.is_empty() && !taken.map.empty() && job.map.withdrawn().empty()) {
            job.map.add(taken.map);
            add.map = pack_map(taken.map);
        }
        writer_.write(std::move(add));
    }
    for (const Dispute& dispute : disputes) {
        writer_.promise(dispute);
    }
}

std::vector<Dispute> JobMerger::merge_into(MasterJob& job,
                                           TakenResults& taken,
                                           const std::shared_ptr<const Author>& author,
                                           AddResults& add) {
    std::vector<Dispute> disputes;
    std::vector<std::size_t> dropped;
    const std::vector<Sha256> digests = taken.results.digests();
    for (std::size_t i = 0; i < taken.results.size(); ++i) {
        const ResultRow& row = taken.results.rows()[i];
        const Sha256& digest = digests[i];
        const auto outcome = job.merged.add(row.scenario, row.facts, digest, author);
        if (outcome == MergedResults::Outcome::Added) {
            if (JobWork* work = job.work()) {
                work->open.close(taken.positions_of_rows[i]);
            }
            continue;
        }
        const bool is_repeated = outcome == MergedResults::Outcome::Repeated;
        if (is_repeated && mutated(Mutation::SecondAnswerMerged)) {
            continue;
        }
        dropped.push_back(i);
        if (outcome == MergedResults::Outcome::Foreign) {
            log_error(
                "result for an unknown scenario: job={} scenario={}", job.id.value, row.scenario);
        }
        // A failure by the master is final: the scenario was cancelled, or may crash the process
        // that runs it, so the master must not run it to decide a dispute.
        if (outcome == MergedResults::Outcome::Differs && author != nullptr &&
            !job.merged.is_failed_by_master(row.scenario)) {
            disputes.push_back(open_dispute(job, {job.id, row.scenario, author, digest}, add));
        }
    }
    add.results = dropped.empty() ? std::move(taken.results) : taken.results.without(dropped);
    return disputes;
}

void JobMerger::fail(MasterJob& job, const PlacedScenario& placed, const std::string& why) {
    const Error error{ErrorCode::Interrupted, why};
    TakenResults taken;
    taken.add(failed_result(placed.scenario, job.submit.query, error), placed.position, {});
    merge(job, std::move(taken), nullptr);
    life_.end_if_complete(job);
}

} // namespace cd
