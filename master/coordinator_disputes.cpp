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
    const WorkerId author{index < job.authors.size() ? job.authors[index] : 0};
    const bool first_is_right = job.merger.digest_of(index) == right.digest;
    if (!first_is_right) {
        alarm(where + " differ, and the master's own says that the first one, of " +
              (author == WorkerId{} ? std::string("an unknown worker")
                                    : "worker " + std::to_string(author.value)) +
              ", was wrong; it is corrected");
        job.merger.correct(index, first, facts_of(right.result), right.digest);
        withdraw_map(job, "a result of the job was wrong and has been corrected");
        if (author != WorkerId{}) {
            job.authors[index] = 0; // The master's now.
        }
        AddResults add{job.id, job.results, {}, job.progress(Clock::now()), {}};
        const ResultRow row{index, right.record.size(), facts_of(right.result), right.digest};
        add.results.push_back({row, std::move(right.record)});
        write(std::move(add));
    }
    if (dispute.digest != right.digest) {
        alarm(where + " differ, and the master's own says that worker " +
              std::to_string(dispute.second.value) + " is wrong");
        quarantine(dispute.second);
    }
    if (!first_is_right && author != WorkerId{}) {
        quarantine(author);
    }
}

bool Coordinator::is_quarantined(WorkerId worker) const {
    const auto link = workers_.find(worker);
    const auto known = instances_.find(worker);
    return (link != workers_.end() && link->second.quarantined) ||
           (known != instances_.end() && quarantined_.contains(known->second));
}

bool Coordinator::is_same_process(WorkerId one, WorkerId other) const {
    const auto first = instances_.find(one);
    const auto second = instances_.find(other);
    const bool are_known = first != instances_.end() && second != instances_.end();
    return one == other || (are_known && first->second != 0 && first->second == second->second);
}

void Coordinator::quarantine(WorkerId worker) {
    if (worker == WorkerId{} || is_quarantined(worker)) {
        return;
    }
    spdlog::error("worker quarantined: worker={}", worker.value);
    if (const auto known = instances_.find(worker);
        known != instances_.end() && known->second != 0) {
        quarantined_.insert(known->second);
    }
    doubt_results_of(worker);
    // It may have left, and come back as another.
    for (auto& [id, link] : workers_) {
        if (is_same_process(id, worker)) {
            link.quarantined = true;
            blocks_.worker_left(id);
            forget_tasks(id);
            act(dispatcher().worker_lost(id));
        }
    }
}

void Coordinator::doubt_results_of(WorkerId worker) {
    std::string ended;
    for (const JobStatus& known : jobs_.statuses(Clock::now())) {
        MasterJob& job = *jobs_.find(known.job);
        const auto is_his = [&](WorkerId author) { return is_same_process(author, worker); };
        if (!std::any_of(job.contributors.begin(), job.contributors.end(), is_his)) {
            continue;
        }
        if (!job.is_running()) {
            ended += (ended.empty() ? "" : ", ") + std::to_string(job.id.value);
            continue;
        }
        std::vector<std::uint64_t> scenarios;
        for (std::uint64_t index = 0; index < job.authors.size(); ++index) {
            if (job.authors[index] != 0 && is_his(WorkerId{job.authors[index]})) {
                scenarios.push_back(index);
            }
        }
        doubt(job, scenarios);
    }
    if (!ended.empty()) {
        alarm("jobs that have ended hold results of worker " + std::to_string(worker.value) +
              ", which was wrong elsewhere; submit them again: " + ended);
    }
}

void Coordinator::doubt(MasterJob& job, const std::vector<std::uint64_t>& scenarios) {
    std::map<std::uint64_t, std::vector<std::uint64_t>> by_window;
    std::uint64_t count = 0;
    for (const std::uint64_t index : scenarios) {
        if (job.doubted.insert(index).second) {
            by_window[index / limits::order_window_scenarios].push_back(index);
            ++count;
        }
    }
    if (count != 0) {
        spdlog::warn("results are done again: job={} scenarios={}", job.id.value, count);
        withdraw_map(job, "a worker that has contributed to it was wrong elsewhere");
        ++job.changes;
    }
    for (auto& [window, indices] : by_window) {
        if (job.order->grid() != nullptr) {
            do_again(job, std::move(indices)); // On a grid a place is an index.
            continue;
        }
        parts_.blocking.post([this,
                              executor = parts_.executor,
                              id = job.id,
                              order = job.order,
                              indices = std::move(indices)] {
            auto found = order->window_of(indices.front());
            asio::post(executor, [this, id, indices, found] {
                MasterJob* running = jobs_.find_running(id);
                if (running == nullptr) {
                    return;
                }
                if (!found) {
                    return end_job(*running, JobState::Failed, found.error().detail);
                }
                std::vector<std::uint64_t> places;
                for (const std::uint64_t index : indices) {
                    places.push_back(found.value()->place_of(index));
                }
                do_again(*running, std::move(places));
                feed();
            });
        });
    }
}

void Coordinator::do_again(MasterJob& job, std::vector<std::uint64_t> places) {
    std::sort(places.begin(), places.end());
    std::vector<PlaceRange> runs;
    for (const std::uint64_t place : places) {
        if (runs.empty() || runs.back().end() != place) {
            runs.push_back({place, 0});
        }
        ++runs.back().count;
    }
    for (const PlaceRange& run : runs) {
        job.todo.put_back({run, 1}); // So that each is analysed, and out once only.
    }
}

/// Another worker has answered it, or the master will.
void Coordinator::doubt_ends(MasterJob& job, std::uint64_t scenario, WorkerId by) {
    if (job.doubted.erase(scenario) != 0) {
        job.authors[scenario] = 0; // The author's word is not all that stands for it.
        ++job.changes;
        close_analysis(job, scenario);
        act(dispatcher().scenario_answered(by, job.id, scenario));
    }
}

/// Of workers that are gone, once no job runs whose results could be theirs.
void Coordinator::forget_instances() {
    if (jobs_.running().empty()) {
        std::erase_if(instances_,
                      [this](const auto& known) { return !workers_.contains(known.first); });
    }
}

} // namespace cd
