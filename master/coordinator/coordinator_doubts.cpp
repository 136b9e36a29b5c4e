// Quarantine and suspect results. A worker that was wrong once gets no work, and all its answers
// become suspect.
//
// Suspect results are not journaled: they follow from the quarantine, from each result's author and
// from the workers that vouch for it, and the journal has all three.
#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/run_on.hpp"
#include "master/coordinator/coordinator.hpp"

#include <algorithm>
#include <unordered_set>

namespace cd {

// ---- Identities ---------------------------------------------------------------------------------

bool Coordinator::is_distrusted(WorkerId worker) const {
    const auto link = workers_.find(worker);
    return is_quarantined(worker) || (link != workers_.end() && link->second.quarantined);
}

bool Coordinator::is_quarantined(WorkerId worker) const {
    const auto link = workers_.find(worker);
    return quarantined_.contains(sessions_.process_of(worker)) ||
           (link != workers_.end() && link->second.quarantined);
}

std::string Coordinator::name_of(WorkerId worker) const {
    const WorkerProcess process = sessions_.process_of(worker);
    const auto is_its = [&](WorkerId id) {
        return id == worker || (process != 0 && sessions_.process_of(id) == process);
    };
    const auto named = [this](const std::string& name, WorkerId id) {
        const std::string holder = sessions_.holder_of(id);
        return name + " (w-" + std::to_string(id.value) +
               (holder.empty() ? ")" : ", certified as " + holder + ")");
    };
    // The process may have left and rejoined under another id.
    for (const auto& [id, link] : workers_) {
        if (is_its(id)) {
            return named(link.name, id);
        }
    }
    for (const auto& [id, lost] : lost_) {
        if (is_its(id)) {
            return named(lost.status.name, id);
        }
    }
    return sessions_.is_earlier(worker) ? "a worker that is not here any more"
                                        : "w-" + std::to_string(worker.value);
}

WorkerId Coordinator::earlier_worker(WorkerProcess process) {
    if (process == 0) {
        return {};
    }
    const WorkerId found = sessions_.earlier(process, WorkerId{worker_last_ + 1});
    worker_last_ = std::max(worker_last_, found.value);
    return found;
}

void Coordinator::forget_sessions() {
    const std::set<JobId>& running = jobs_.running();
    if (std::ranges::any_of(running, [this](JobId id) { return jobs_.find(id)->disputes != 0; })) {
        return; // A dispute may still need any session.
    }
    std::unordered_set<std::uint64_t> needed; // Authors of current results.
    for (const JobId id : running) {
        const std::vector<std::uint32_t>& authors = jobs_.find(id)->authors;
        needed.insert(authors.begin(), authors.end());
    }
    sessions_.forget(
        [&](WorkerId worker) { return workers_.contains(worker) || needed.contains(worker.value); },
        running.empty());
}

// ---- After a restart ----------------------------------------------------------------------------

void Coordinator::restore_authors(MasterJob& job,
                                  std::span<const std::uint64_t> done,
                                  std::span<const WorkerProcess> authors,
                                  std::span<const Remark> disputes) {
    for (std::size_t i = 0; i < done.size(); ++i) {
        if (authors[i] == 0) {
            continue;
        }
        job.authors.resize(std::max<std::size_t>(job.authors.size(), done[i] + 1));
        job.authors[done[i]] = static_cast<std::uint32_t>(earlier_worker(authors[i]).value);
        if (quarantined_.contains(authors[i])) {
            job.doubted.insert(done[i]);
        }
    }
    for (const Remark& open : disputes) {
        job.disputes_left.push_back(
            {job.id, open.scenario, earlier_worker(open.author), open.digest});
    }
    job.disputes = job.disputes_left.size();
    if (!job.doubted.empty() || job.disputes != 0) {
        log_warning("results are still in doubt: job={} scenarios={} disputes={}",
                    job.id.value,
                    job.doubted.size(),
                    job.disputes);
    }
    if (!job.doubted.empty()) {
        withdraw_map(job, "a worker that has contributed to it was wrong elsewhere");
    }
}

void Coordinator::take_up_doubts(MasterJob& job) {
    for (const Dispute& dispute : std::exchange(job.disputes_left, {})) {
        spawn(parts_.executor, "results that differ", settle_dispute(dispute));
    }
    const std::vector<std::uint64_t> scenarios(job.doubted.begin(), job.doubted.end());
    answer_again(job, scenarios);
}

// ---- Quarantine ---------------------------------------------------------------------------------

void Coordinator::quarantine(WorkerId worker) {
    const WorkerProcess process = sessions_.process_of(worker);
    if (process == 0 || is_quarantined(worker)) {
        return;
    }
    log_error("worker quarantined: worker={}", worker.value);
    alarms_.quarantine(process);
    quarantine_holder(worker);
    quarantined_ = {alarms_.quarantined.begin(), alarms_.quarantined.end()};
    doubt_results_of(worker);
    // The process may have left and rejoined under another id.
    for (auto& [id, link] : workers_) {
        if (sessions_.process_of(id) == process) {
            link.quarantined = true;
            blocks_.worker_left(id);
            take_all_back(id); // The process is alive, so the work is not lost with it.
            forget_tasks(id);
            act(dispatcher().worker_lost(id));
        }
    }
}

void Coordinator::doubt_results_of(WorkerId worker) {
    const WorkerProcess process = sessions_.process_of(worker);
    const std::set<WorkerId> sessions = sessions_.all_of(process);
    std::string ended;
    for (const JobStatus& known : jobs_.statuses(Clock::now())) {
        MasterJob& job = *jobs_.find(known.job);
        if (!job.contributors.contains(process)) {
            continue;
        }
        if (!job.is_running()) {
            ended += (ended.empty() ? "" : ", ") + std::to_string(job.id.value);
            continue;
        }
        std::vector<std::uint64_t> scenarios;
        for (std::uint64_t index = 0; index < job.authors.size(); ++index) {
            if (sessions.contains(WorkerId{job.authors[index]})) {
                scenarios.push_back(index);
            }
        }
        doubt(job, scenarios);
    }
    if (!ended.empty()) {
        alarm("jobs that have ended hold results of " + name_of(worker) +
              ", which was wrong elsewhere; submit them again: " + ended);
    }
}

// ---- Suspect results ----------------------------------------------------------------------------

void Coordinator::doubt(MasterJob& job, const std::vector<std::uint64_t>& scenarios) {
    std::vector<std::uint64_t> doubted;
    for (const std::uint64_t index : scenarios) {
        if (job.doubted.insert(index).second) {
            doubted.push_back(index);
        }
    }
    if (doubted.empty()) {
        return;
    }
    log_warning(
        "results in doubt are recomputed: job={} scenarios={}", job.id.value, doubted.size());
    withdraw_map(job, "a worker that has contributed to it was wrong elsewhere");
    ++job.changes;
    if (job.order != nullptr) { // Otherwise this happens once the geometry is loaded.
        answer_again(job, doubted);
    }
}

void Coordinator::answer_again(MasterJob& job, std::span<const std::uint64_t> scenarios) {
    std::map<std::uint64_t, std::vector<std::uint64_t>> by_window;
    for (const std::uint64_t index : scenarios) {
        by_window[index / limits::order_window_scenarios].push_back(index);
    }
    for (auto& [window, indices] : by_window) {
        if (job.order->grid() != nullptr) {
            do_again(job, std::move(indices)); // On a grid the order position equals the index.
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
                    return wait_for_disk(*running, found.error(), [this, id, indices] {
                        answer_again(*jobs_.find(id), indices);
                    });
                }
                disk_gives(*running);
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
        job.todo.put_back({run, Losses::in_doubt()});
    }
}

/// Another worker has answered the scenario, or the master will.
bool Coordinator::doubt_ends(MasterJob& job, std::uint64_t scenario, WorkerId by) {
    if (job.doubted.erase(scenario) == 0) {
        return false;
    }
    ++job.changes;
    close_analysis(job, scenario);
    act(dispatcher().scenario_answered(by, job.id, scenario));
    return true;
}

void Coordinator::give_up_doubt(MasterJob& job, const Scenario& scenario, const std::string& why) {
    doubt_ends(job, scenario.index, WorkerId{});
    job.given_up.insert(scenario.index);
    ++job.disputes; // Keeps the job open until the scenario has failed.
    spawn(parts_.executor, "scenario in doubt given up", fail_doubted(job.id, scenario, why));
}

asio::awaitable<void> Coordinator::fail_doubted(JobId id, Scenario scenario, std::string why) {
    MasterJob* job = jobs_.find_running(id);
    const std::uint64_t index = scenario.index;
    for (;;) {
        if (job == nullptr) {
            co_return; // The next incarnation of the master restores the suspicion.
        }
        if (job->authors[index] == 0) {
            break; // A settled dispute has already put the master's result in.
        }
        auto look = [results = job->results, index] { return kept_result(*results, index); };
        const Result<ScenarioResult> kept = co_await run_on(parts_.blocking, look);
        job = jobs_.find_running(id);
        if (kept && job != nullptr && !closed_ && job->authors[index] != 0) {
            disk_gives(*job);
            const Error error{ErrorCode::Interrupted, why};
            AddResults verdict{id, job->results, {}, {}, {}};
            correct(*job,
                    take_result(failed_result(scenario, job->submit.query, error), {}),
                    facts_of(kept.value()),
                    "a scenario whose result was in doubt was given up",
                    verdict);
            job->authors[index] = 0;
            verdict.progress = job->progress(Clock::now());
            write(std::move(verdict));
        } else if (!kept && job != nullptr) {
            job = co_await wait_until_mended(id, kept.error());
        } else if (closed_) {
            co_return;
        }
    }
    disk_gives(*job);
    --job->disputes;
    ++job->changes;
    end_if_complete(*job);
    feed();
}

} // namespace cd
