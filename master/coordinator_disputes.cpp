// Two results of one scenario that differ: a free test of memory and code.
#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/job/packed_records.hpp"
#include "common/job/run_scenario.hpp"
#include "master/coordinator.hpp"
#include "master/run_on.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::size_t alarms_kept = 20;
constexpr std::chrono::milliseconds commit_poll{20};

/// What a dispute is settled by.
struct Evidence {
    TakenResult right;
    ScenarioFacts first; ///< Of the result that was merged.
};

/// Nothing when a failure was merged: it stands. The scenario may be one that takes down whoever
/// runs it, or that somebody has cancelled, and it would run here.
Result<std::optional<Evidence>> find_evidence(const JobMaterial& material,
                                              PoseSource& poses,
                                              const ResultStore& results,
                                              std::uint64_t index) {
    const Result<std::vector<Scenario>> scenario = poses.read(index, 1);
    if (!scenario) {
        return scenario.error();
    }
    const Result<ResultsPart> part = results.read(index, 1, 1);
    if (!part) {
        return part.error();
    }
    const Result<Bytes> records = unpack_records(part.value().records, limits::results_bytes_max);
    if (!records) {
        return records.error();
    }
    ByteReader in(records.value());
    const Result<ScenarioResult> first = decode_result(in.get_bytes(in.get<std::uint32_t>()));
    if (!first) {
        return first.error();
    }
    if (first.value().kind == ScenarioClass::Failed) {
        return std::optional<Evidence>();
    }
    const ScenarioRunner runner(*material.a, *material.b, material.query);
    return std::optional(Evidence{take_result(runner.run(scenario.value().front()).result, {}),
                                  facts_of(first.value())});
}

} // namespace

void Coordinator::alarm(const std::string& text) {
    spdlog::critical("ALARM: {}", text);
    ++alarm_count_;
    alarms_.push_back(text);
    if (alarms_.size() > alarms_kept) {
        alarms_.pop_front();
    }
}

void Coordinator::open_dispute(MasterJob& job, const Dispute& dispute) {
    spdlog::error("results differ: job={} scenario={} worker={}",
                  job.id.value,
                  dispute.scenario,
                  dispute.second.value);
    ++job.disputes;
    spawn(parts_.executor, "results that differ", settle_dispute(dispute));
}

asio::awaitable<void> Coordinator::settle_dispute(Dispute dispute) {
    MasterJob* job = jobs_.find_running(dispute.job);
    asio::steady_timer timer(parts_.executor);
    // What was merged is read from the disk, where it may not be yet.
    while (job != nullptr && !job->results->has(dispute.scenario)) {
        timer.expires_after(commit_poll);
        co_await timer.async_wait(asio::use_awaitable);
        job = jobs_.find_running(dispute.job);
    }
    if (job == nullptr) {
        co_return;
    }
    auto look = [material = job->material,
                 poses = job->poses,
                 results = job->results,
                 index = dispute.scenario] {
        return find_evidence(*material, *poses, *results, index);
    };
    Result<std::optional<Evidence>> evidence = co_await run_on(parts_.blocking, look);
    job = jobs_.find_running(dispute.job);
    if (job == nullptr) {
        co_return;
    }
    --job->disputes;
    if (evidence) {
        if (auto& found = evidence.value()) {
            judge(*job, dispute, std::move(found->right), found->first);
        }
        end_if_complete(*job);
    } else {
        end_job(*job, JobState::Failed, evidence.error().detail);
    }
    feed();
}

void Coordinator::judge(MasterJob& job,
                        const Dispute& dispute,
                        TakenResult right,
                        const ScenarioFacts& first) {
    const std::uint64_t index = dispute.scenario;
    const std::string where =
        "results of job " + std::to_string(job.id.value) + ", scenario " + std::to_string(index);
    if (dispute.digest != right.digest) {
        alarm(where + " differ, and the master's own says that worker " +
              std::to_string(dispute.second.value) + " is wrong");
        quarantine(dispute.second);
    }
    if (job.merger.digest_of(index) == right.digest) {
        return;
    }
    const WorkerId author{index < job.authors.size() ? job.authors[index] : 0};
    alarm(where + " differ, and the master's own says that the first one, of " +
          (author == WorkerId{} ? std::string("an unknown worker")
                                : "worker " + std::to_string(author.value)) +
          ", was wrong; it is corrected, other results of that worker are not");
    job.merger.correct(index, first, facts_of(right.result), right.digest);
    AddResults add{job.id, job.results, {}, job.progress(Clock::now())};
    const ResultRow row{index, right.record.size(), facts_of(right.result), right.digest};
    add.results.push_back({row, std::move(right.record)});
    write(std::move(add));
    if (author != WorkerId{}) {
        quarantine(author);
    }
}

void Coordinator::quarantine(WorkerId worker) {
    const auto link = workers_.find(worker);
    if (link == workers_.end() || link->second.quarantined) {
        return;
    }
    spdlog::error("worker quarantined: worker={} name={}", worker.value, link->second.name);
    link->second.quarantined = true;
    quarantined_.insert(link->second.instance);
    blocks_.worker_left(worker);
    forget_tasks(worker);
    act(dispatcher().worker_lost(worker));
}

} // namespace cd
