// Disputes and quarantine. Two results of one scenario differ: the master's own run decides. A
// process that was wrong goes into quarantine, and in running jobs all its results count as never
// having come. Each duplicate result is thus a free test of memory and code.
//
// A dispute is journaled before the result is acknowledged. The first entry that follows from a
// verdict has the alarm and the quarantine. A restarted master therefore finds either the open
// dispute or the quarantine, and then withdraws what is left of the process's results.
#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "master/base/mutation.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/results/record_size.hpp"

#include <algorithm>

namespace cd {

// ---- Disputes -----------------------------------------------------------------------------------

Dispute Coordinator::open_dispute(MasterJob& job, Dispute dispute, AddResults& add) {
    log_error("results differ: job={} scenario={} worker={}",
              job.id.value,
              dispute.scenario,
              dispute.second->worker.value);
    ++job.disputes;
    add.remarks.push_back(
        {Remark::Kind::Disputed, dispute.scenario, dispute.digest, dispute.second->process});
    return dispute;
}

void Coordinator::run_disputed(const Dispute& dispute) {
    const MasterJob* job = jobs_.find_running(dispute.job);
    if (job == nullptr || closed_) {
        return; // After a restart the master judges it.
    }
    references_.start(job->id,
                      dispute.scenario,
                      job->material,
                      job->poses,
                      [this, dispute](Result<ReferenceResult> found) {
                          MasterJob* running = jobs_.find_running(dispute.job);
                          if (running == nullptr) {
                              return;
                          }
                          if (!found) {
                              return wait_for_disk(
                                  *running, found.error(), [this, dispute](MasterJob*) {
                                      run_disputed(dispute);
                                  });
                          }
                          disk_gives(*running);
                          settle(*running, dispute, std::move(found.value()));
                          feed();
                      });
}

void Coordinator::settle(MasterJob& job, const Dispute& dispute, ReferenceResult right) {
    const std::uint64_t index = dispute.scenario;
    const Status fits = check_record_size(index, right.taken.record.size());
    const bool first_is_right = !job.merged.has(index) || job.merged.is_failed_by_master(index) ||
                                job.merged.digest_of(index) == right.taken.digest;
    if (!right.is_stopped) {
        const std::string where = "results of job " + std::to_string(job.id.value) + ", scenario " +
                                  std::to_string(index);
        if (!first_is_right) {
            const auto first = job.merged.author_of(index);
            alarms_.raise(where + " differ, and the master's own says that the first one, of " +
                          (first == nullptr ? "an unknown worker" : first->to_text()) +
                          ", was wrong; it is corrected");
            if (first != nullptr) {
                quarantine(*first);
            }
        }
        // A process whose results were withdrawn before proves nothing new.
        if (dispute.digest != right.taken.digest &&
            !alarms_.is_quarantined(dispute.second->process)) {
            alarms_.raise(where + " differ, and the master's own says that " +
                          dispute.second->to_text() + " is wrong");
            quarantine(*dispute.second);
        }
    }
    AddResults verdict{job.id, job.results, {}, {}, {}};
    verdict.remarks.push_back(
        {Remark::Kind::Settled, index, dispute.digest, dispute.second->process});
    if (!first_is_right && job.merged.has(index)) {
        job.merged.withdraw_one(index);
        verdict.withdrawn = {index};
        withdraw_map(job, "a result of the job was wrong and has been corrected");
    }
    if (!job.merged.has(index) && fits) {
        (void)merge_one(job, right.taken, nullptr, verdict);
        act(dispatcher().scenario_answered(WorkerId{}, job.id, index));
    }
    verdict.alarms = alarms_.take_changed();
    verdict.progress = job.progress(Clock::now());
    writer_.write(std::move(verdict));
    --job.disputes;
    ++job.changes;
    if (!fits) {
        return end_job(job, JobState::Failed, fits.error().detail);
    }
    end_if_complete(job);
}

// ---- Quarantine ---------------------------------------------------------------------------------

void Coordinator::quarantine(const Author& wrong) {
    if (!alarms_.quarantine(wrong.process)) {
        return;
    }
    log_error("worker quarantined: worker={}", wrong.worker.value);
    withdraw_results_of(wrong);
    // The process may have left and rejoined under another id.
    for (const WorkerId id : workers_.quarantine(wrong.process)) {
        blocks_.worker_left(id);
        take_all_back(id); // The process is alive, so the work is not lost with it.
        forget_tasks(id);
        act(dispatcher().worker_lost(id));
    }
}

void Coordinator::withdraw_results_of(const Author& wrong) {
    std::string ended;
    std::vector<MasterJob*> running;
    for (const JobStatus& known : jobs_.statuses(Clock::now())) {
        MasterJob& job = *jobs_.find(known.job);
        if (job.is_running()) {
            running.push_back(&job);
        } else if (job.contributors.contains(wrong.process)) {
            ended += (ended.empty() ? "" : ", ") + std::to_string(job.id.value);
        }
    }
    if (!ended.empty()) {
        alarms_.raise("jobs that have ended hold results of " + wrong.to_text() +
                      ", which was wrong elsewhere; check them with cdctl verify: " + ended);
    }
    for (MasterJob* job : running) {
        withdraw_results_of(wrong, *job);
    }
}

void Coordinator::withdraw_results_of(const Author& wrong, MasterJob& job) {
    if (mutated(Mutation::LiarKept)) {
        return;
    }
    std::vector<std::uint64_t> scenarios = job.merged.withdraw(wrong.process);
    if (scenarios.empty()) {
        return;
    }
    log_warning("results withdrawn: job={} scenarios={} worker={}",
                job.id.value,
                scenarios.size(),
                wrong.worker.value);
    job.withdrawn += scenarios.size();
    job.done.reset();
    ++job.changes;
    withdraw_map(job, "a worker that has contributed to it was wrong elsewhere");
    if (job.order != nullptr) { // Otherwise all scenarios without a result are handed out later.
        hand_out_again(job, scenarios);
    }
    AddResults withdrawal{job.id, job.results, {}, {}, {}};
    withdrawal.remarks.push_back({Remark::Kind::Withdrawn, 0, {}, wrong.process});
    withdrawal.withdrawn = std::move(scenarios);
    withdrawal.progress = job.progress(Clock::now());
    withdrawal.alarms = alarms_.take_changed(); // No withdrawal is durable without its quarantine.
    writer_.write(std::move(withdrawal));
}

void Coordinator::hand_out_again(MasterJob& job, std::span<const std::uint64_t> scenarios) {
    std::map<std::uint64_t, std::vector<std::uint64_t>> by_window;
    for (const std::uint64_t index : scenarios) {
        by_window[index / limits::order_window_scenarios].push_back(index);
    }
    for (auto& [window, indices] : by_window) {
        if (job.order->grid() != nullptr) {
            put_back_places(job, std::move(indices)); // On a grid the position equals the index.
            continue;
        }
        job.places_loading += indices.size();
        parts_.blocking.post([this,
                              executor = parts_.executor,
                              id = job.id,
                              order = job.order,
                              indices = std::move(indices)] {
            asio::post(executor, [this, id, indices, found = order->window_of(indices.front())] {
                MasterJob* running = jobs_.find_running(id);
                if (running == nullptr) {
                    return;
                }
                if (!found) {
                    return wait_for_disk(
                        *running, found.error(), [this, indices](MasterJob* again) {
                            if (again != nullptr) {
                                again->places_loading -= indices.size();
                                hand_out_again(*again, indices);
                            }
                        });
                }
                running->places_loading -= indices.size();
                disk_gives(*running);
                std::vector<std::uint64_t> places;
                for (const std::uint64_t index : indices) {
                    places.push_back(found.value()->place_of(index));
                }
                put_back_places(*running, std::move(places));
                feed();
            });
        });
    }
}

/// Queues positions, except those that are queued or handed out already.
void Coordinator::put_back_places(MasterJob& job, std::vector<std::uint64_t> places) {
    std::sort(places.begin(), places.end());
    std::vector<PlaceRange> runs;
    for (const std::uint64_t place : places) {
        if (runs.empty() || runs.back().end() != place) {
            runs.push_back({place, 0});
        }
        ++runs.back().count;
    }
    for (const PlaceQueue::Piece& piece : job.todo.pieces()) {
        runs = without(runs, piece.places);
    }
    for (const PlaceRange& unsent : dispatcher_.places_of(job.id)) {
        runs = without(runs, unsent);
    }
    for (const auto& [id, task] : tasks_) {
        if (task.content->job == job.id && task.places) {
            runs = without(runs, *task.places);
        }
    }
    for (const PlaceRange& run : runs) {
        job.todo.put_back({run});
    }
}

} // namespace cd
