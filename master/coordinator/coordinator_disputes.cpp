// Two results of one scenario that differ: a free test of memory and code.
//
// That they do is in the journal before it is acknowledged, and the verdict is one entry of it: the
// right result, the alarm, the quarantine, and that nothing is in dispute any more. So a master
// that ends anywhere between begins with the same question, or with all of the answer.
#include "common/core/host/log.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/results/record_size.hpp"

#include <algorithm>

namespace cd {

/// What a dispute is settled by.
struct Coordinator::Evidence {
    TakenResult right;
    ScenarioFacts first;       ///< Of the result that was merged.
    bool is_cancelled = false; ///< Nobody knows what is right, and nobody is to blame.

    struct Case {
        std::shared_ptr<const JobMaterial> material;
        std::shared_ptr<PoseSource> poses;
        std::shared_ptr<const ResultStore> results;
        std::uint64_t scenario = 0;
        bool is_masters = false; ///< What was merged, as far as is known.
    };
    [[nodiscard]] static Result<std::optional<Evidence>> find(const Case& dispute,
                                                              const StopCheck& stop);
};

/// Nothing when a failure of the master's was merged: it stands. The scenario may be one that takes
/// down whoever runs it, or that somebody has cancelled, and it would run here. A worker that says
/// of a scenario that it fails may be as wrong as with any other answer.
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
            break; // It fails, and to be judged it would run here.
        }
        const bool is_masters = index >= job->authors.size() || job->authors[index] == 0;
        const Sha256 merged = job->merger.digest_of(index);
        auto look = [content =
                         Evidence::Case{job->material, job->poses, job->results, index, is_masters},
                     stop] { return Evidence::find(content, [stop] { return stop->load(); }); };
        Result<std::optional<Evidence>> found = co_await run_on(parts_.blocking, look);
        job = closed_ ? nullptr : jobs_.find_running(dispute.job);
        if (job == nullptr) {
            break; // The next life of the master begins with it.
        }
        if (!found) {
            job = co_await wait_until_mended(dispute.job, found.error());
        } else if (job->merger.digest_of(index) == merged) { // Else it was corrected meanwhile.
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
    doubt_ends(job, dispute.scenario, WorkerId{}); // Its author may be in quarantine meanwhile.
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
        job.authors[index] = 0; // The master's own stands for it.
    }
    if (evidence.is_cancelled) {
        if (!first_is_right) { // It was not cancelled by another dispute before.
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
    // What came again, as after a restart, tells nothing new.
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
