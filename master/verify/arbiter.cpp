#include "master/verify/arbiter.hpp"

#include "master/compute/record_size.hpp"

#include <utility>

namespace cd {

Verdict judge(const std::optional<Sha256>& merged, const Sha256& second, const Sha256& right) {
    return {merged && *merged != right, second != right};
}

void Arbiter::settle(const Dispute& dispute) {
    const MasterJob* job = parts_.jobs.find_running(dispute.job);
    if (job == nullptr) {
        return;
    }
    parts_.references.start(
        job->id,
        dispute.scenario,
        job->work()->material,
        job->run->poses,
        [this, dispute](Result<ReferenceResult> found) { ran(dispute, std::move(found)); });
}

void Arbiter::ran(const Dispute& dispute, Result<ReferenceResult> found) {
    MasterJob* job = parts_.jobs.find_running(dispute.job);
    if (job == nullptr) {
        return;
    }
    if (!found) {
        return parts_.life.wait_for_disk(
            *job, found.error(), [this, dispute](MasterJob*) { settle(dispute); });
    }
    parts_.life.disk_gives(*job);
    close(*job, dispute, std::move(found.value()));
}

void Arbiter::close(MasterJob& job, const Dispute& dispute, ReferenceResult right) {
    const std::uint64_t index = dispute.scenario;
    const Status fits = check_record_size(index, right.taken.results.record_bytes());
    const bool is_judged = job.merged.has(index) && !job.merged.is_failed_by_master(index);
    const Verdict verdict =
        judge(is_judged ? std::optional(job.merged.digest_of(index)) : std::nullopt,
              dispute.digest,
              right.taken.results.digests().front());
    if (!right.is_stopped) { // Otherwise the right result is unknown.
        punish(job, dispute, verdict);
    }
    AddResults entry{job.id, job.results, {}, {}, {}};
    entry.remarks.push_back(
        {Remark::Kind::Settled, index, dispute.digest, dispute.second->process});
    // The quarantine may have withdrawn the merged result.
    if (verdict.first_is_wrong && job.merged.has(index)) {
        job.merged.withdraw_one(index);
        entry.withdrawn = {index};
        withdraw_map(job, "a result of the job was wrong and has been corrected");
    }
    if (!job.merged.has(index) && fits) {
        const PositionRange position{right.taken.positions_of_rows.front(), 1};
        (void)JobMerger::merge_into(job, right.taken, nullptr, entry);
        parts_.dispatch.act(parts_.dispatch->answered({{}, {}, job.id, position}));
    }
    entry.alarms = parts_.alarms.take_changed();
    entry.progress = job.progress(parts_.jobs.now());
    parts_.writer.write(std::move(entry));
    --job.run->disputes;
    ++job.changes;
    if (!fits) {
        return parts_.life.end(job, JobState::Failed, fits.error().detail);
    }
    parts_.life.end_if_complete(job);
}

void Arbiter::punish(const MasterJob& job, const Dispute& dispute, const Verdict& verdict) {
    const std::string differ = "results of job " + std::to_string(job.id.value) + ", scenario " +
                               std::to_string(dispute.scenario) +
                               " differ, and the master's own says that ";
    if (verdict.first_is_wrong) {
        const auto first = job.merged.author_of(dispute.scenario);
        parts_.alarms.raise(differ + "the first one, of " +
                            (first == nullptr ? "an unknown worker" : first->to_text()) +
                            ", was wrong; it is corrected");
        if (first != nullptr) {
            parts_.quarantine.impose(*first);
        }
    }
    // A process that is in quarantine already needs no second alarm.
    if (verdict.second_is_wrong && !parts_.alarms.is_quarantined(dispute.second->process)) {
        parts_.alarms.raise(differ + dispute.second->to_text() + " is wrong");
        parts_.quarantine.impose(*dispute.second);
    }
}

} // namespace cd
