// Disputes: two results of one scenario differ. Each duplicate result is a free test of memory and
// code.
//
// A dispute is journaled before the result is acknowledged. The verdict is one journal entry: right
// result, alarm, quarantine and end of the dispute. A restarted master therefore finds either the
// open dispute or the whole verdict.
#include "common/core/host/log.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/results/record_size.hpp"

#include <algorithm>

namespace cd {

/// The evidence that settles a dispute.
struct Coordinator::Evidence {
    TakenResult right;
    ScenarioFacts first;       ///< Facts of the merged result.
    bool is_cancelled = false; ///< The right result is unknown; nobody is blamed.

    struct Case {
        std::shared_ptr<const JobMaterial> material;
        std::shared_ptr<PoseSource> poses;
        std::shared_ptr<const ResultStore> results;
        std::uint64_t scenario = 0;
        bool is_masters = false; ///< As far as is known, the merged result is the master's.
    };
    [[nodiscard]] static Result<std::optional<Evidence>> find(const Case& dispute,
                                                              const StopCheck& stop);
};

/// Returns nothing if the merged result is a failure recorded by the master: it stays. Such a
/// scenario may kill its runner or was cancelled, so the master must not run it. A failure reported
/// by a worker is checked like any other answer.
Result<std::optional<Coordinator::Evidence>> Coordinator::Evidence::find(const Case& dispute,
                                                                         const StopCheck& stop) {
    const Result<ScenarioResult> first = kept_result(*dispute.results, dispute.scenario);
    if (!first) {
        return first.error();
    }
    if (first.value().kind == ScenarioClass::Failed && dispute.is_masters) {
        return std::optional<Evidence>();
    }
    const Result<std::vector<Scenario>> read = dispute.poses->read(dispute.scenario, 1);
    if (!read) {
        return read.error();
    }
    const Scenario& scenario = read.value().front();
    const JobMaterial& material = *dispute.material;
    const ScenarioRunner runner(*material.a, *material.b, material.query, PairStage::Float, stop);
    ScenarioRun run;
    run.is_stopped = stop();
    if (!run.is_stopped) {
        run = runner.run(scenario);
    }
    if (run.is_stopped) {
        run.result = failed_result(scenario, material.query, {ErrorCode::Interrupted, "cancelled"});
    }
    return std::optional(
        Evidence{take_result(std::move(run.result), {}), facts_of(first.value()), run.is_stopped});
}

void Coordinator::alarm(const std::string& text) {
    log_critical("ALARM: {}", text);
    alarms_.add(text);
}

void Coordinator::open_dispute(MasterJob& job, const Dispute& dispute, AddResults& add) {
    log_error("results differ: job={} scenario={} worker={}",
              job.id.value,
              dispute.scenario,
              dispute.second.value);
    ++job.disputes;
    add.remarks.push_back({Remark::Kind::Disputed,
                           dispute.scenario,
                           dispute.digest,
                           sessions_.process_of(dispute.second)});
    ledger_.promise(dispute, written_ + 1);
}

asio::awaitable<void> Coordinator::settle_dispute(Dispute dispute) {
    MasterJob* job = jobs_.find_running(dispute.job);
    if (job == nullptr) {
        co_return;
    }
    const std::uint64_t index = dispute.scenario;
    const auto stop = std::make_shared<std::atomic<bool>>(closed_);
    const auto judging = judging_.emplace(std::pair(dispute.job, index), stop);
    bool is_over = false;
    std::optional<Evidence> evidence;
    while (job != nullptr && !is_over) {
        if (job->given_up.contains(index)) {
            break; // The scenario fails; judging it would run it here.
        }
        const bool is_masters = index >= job->authors.size() || job->authors[index] == 0;
        const Sha256 merged = job->merger.digest_of(index);
        auto look = [content =
                         Evidence::Case{job->material, job->poses, job->results, index, is_masters},
                     stop] { return Evidence::find(content, [stop] { return stop->load(); }); };
        Result<std::optional<Evidence>> found = co_await run_on(parts_.blocking, look);
        job = closed_ ? nullptr : jobs_.find_running(dispute.job);
        if (job == nullptr) {
            break; // The next incarnation of the master judges it.
        }
        if (!found) {
            job = co_await wait_until_mended(dispute.job, found.error());
        } else if (job->merger.digest_of(index) == merged) { // Not corrected meanwhile.
            disk_gives(*job);
            evidence = std::move(found.value());
            is_over = true;
        }
    }
    judging_.erase(judging);
    if (job != nullptr) {
        settle(*job, dispute, std::move(evidence));
        feed();
    }
}

void Coordinator::settle(MasterJob& job, const Dispute& dispute, std::optional<Evidence> evidence) {
    const std::uint64_t alarms_before = alarms_.count;
    AddResults verdict{job.id, job.results, {}, {}, {}};
    const WorkerProcess second = sessions_.process_of(dispute.second);
    verdict.remarks.push_back({Remark::Kind::Settled, dispute.scenario, dispute.digest, second});
    const Status fits =
        evidence ? judge(job, dispute, std::move(*evidence), verdict) : Status(Done{});
    if (alarms_.count != alarms_before) {
        verdict.alarms = alarms_;
    }
    verdict.progress = job.progress(Clock::now());
    write(std::move(verdict));
    doubt_ends(job, dispute.scenario, WorkerId{}); // The author may be quarantined now.
    --job.disputes;
    ++job.changes;
    if (!fits) {
        return end_job(job, JobState::Failed, fits.error().detail);
    }
    end_if_complete(job);
}

bool Coordinator::stop_judging(JobId job, std::optional<std::uint64_t> scenario) {
    bool any = false;
    for (const auto& [place, stop] : judging_) {
        if (place.first == job && (!scenario || place.second == *scenario)) {
            *stop = true;
            any = true;
        }
    }
    return any;
}

Status
Coordinator::judge(MasterJob& job, const Dispute& dispute, Evidence evidence, AddResults& verdict) {
    const std::uint64_t index = dispute.scenario;
    const std::string where =
        "results of job " + std::to_string(job.id.value) + ", scenario " + std::to_string(index);
    const WorkerId author{index < job.authors.size() ? job.authors[index] : 0};
    const bool first_is_right = job.merger.digest_of(index) == evidence.right.digest;
    const bool second_is_right = dispute.digest == evidence.right.digest;
    if (author != WorkerId{}) {
        job.authors[index] = 0; // The master's own result replaces it.
    }
    if (evidence.is_cancelled) {
        if (!first_is_right) { // False if another dispute cancelled it before.
            correct(job,
                    std::move(evidence.right),
                    evidence.first,
                    "a scenario with results that differ was cancelled",
                    verdict);
        }
        return Done{};
    }
    const Status fits = check_record_size(index, evidence.right.record.size());
    const bool is_known_wrong = !first_is_right && is_quarantined(author);
    if (is_known_wrong) {
        log_warning("a result in doubt is corrected: job={} scenario={}", job.id.value, index);
    } else if (!first_is_right) {
        alarm(where + " differ, and the master's own says that the first one, of " +
              (author == WorkerId{} ? "an unknown worker" : name_of(author)) +
              ", was wrong; it is corrected");
    }
    if (!first_is_right && fits) {
        correct(job,
                std::move(evidence.right),
                evidence.first,
                "a result of the job was wrong and has been corrected",
                verdict);
    }
    // A repeated message, for example after a restart, proves nothing new.
    if (!second_is_right && dispute.second != WorkerId{} && !is_quarantined(dispute.second)) {
        alarm(where + " differ, and the master's own says that " + name_of(dispute.second) +
              " is wrong");
        quarantine(dispute.second);
    }
    if (!first_is_right) {
        quarantine(author);
    }
    return fits;
}

void Coordinator::correct(MasterJob& job,
                          TakenResult right,
                          const ScenarioFacts& wrong,
                          const std::string& why,
                          AddResults& verdict) {
    const std::uint64_t index = right.result.index;
    job.merger.correct(index, wrong, facts_of(right.result), right.digest);
    withdraw_map(job, why);
    const ResultRow row{index, right.record.size(), facts_of(right.result), right.digest};
    verdict.results.push_back({row, std::move(right.record)});
}

} // namespace cd
