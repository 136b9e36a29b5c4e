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
    for (const TakenResult& one : taken.results) {
        if (const Status fits = check_record_size(one.result.index, one.record.size()); !fits) {
            return life_.end(job, JobState::Failed, fits.error().detail);
        }
    }
    AddResults add{job.id, job.results, {}, {}, {}};
    std::vector<Dispute> disputes;
    add.author = author == nullptr ? 0 : author->process;
    add.results.reserve(taken.results.size());
    for (TakenResult& one : taken.results) {
        job.tally.statistics += one.cost;
        if (auto dispute = merge_one(job, one, author, add)) {
            disputes.push_back(std::move(*dispute));
        }
    }
    meter_.count(add.results.size());
    if (!add.results.empty() || !add.remarks.empty()) {
        ++job.changes;
        add.progress = job.progress(life_.now());
        if (!add.results.empty() && !taken.map.empty() && job.map.withdrawn().empty()) {
            job.map.add(taken.map);
            add.map = pack_map(taken.map);
        }
        writer_.write(std::move(add));
    }
    for (const Dispute& dispute : disputes) {
        writer_.promise(dispute);
    }
}

std::optional<Dispute> JobMerger::merge_one(MasterJob& job,
                                            TakenResult& taken,
                                            const std::shared_ptr<const Author>& author,
                                            AddResults& add) {
    const std::uint64_t index = taken.result.index;
    const ScenarioFacts facts = facts_of(taken.result);
    switch (job.merged.add(index, facts, taken.digest, author)) {
    case MergedResults::Outcome::Repeated:
        if (!mutated(Mutation::SecondAnswerMerged)) {
            return std::nullopt;
        }
        break;
    case MergedResults::Outcome::Differs:
        // A failure by the master is final: the scenario was cancelled, or may crash the process
        // that runs it, so the master must not run it to decide a dispute.
        if (author != nullptr && !job.merged.is_failed_by_master(index)) {
            return open_dispute(job, {job.id, index, author, taken.digest}, add);
        }
        return std::nullopt;
    case MergedResults::Outcome::Foreign:
        log_error("result for an unknown scenario: job={} scenario={}", job.id.value, index);
        return std::nullopt;
    case MergedResults::Outcome::Added:
        if (JobWork* work = job.work()) {
            work->open.close(taken.position);
        }
    }
    const ResultRow row{index, taken.record.size(), facts, taken.digest};
    add.results.push_back({row, std::move(taken.record)});
    return std::nullopt;
}

void JobMerger::fail(MasterJob& job, const PlacedScenario& placed, const std::string& why) {
    const Error error{ErrorCode::Interrupted, why};
    std::vector<TakenResult> taken;
    taken.push_back(
        take_result(failed_result(placed.scenario, job.submit.query, error), placed.position, {}));
    merge(job, {std::move(taken), {}}, nullptr);
    life_.end_if_complete(job);
}

} // namespace cd
