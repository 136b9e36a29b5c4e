#include "master/coordinator/coordinator.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/remedy.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/coordinator/invariants.hpp"
#include "master/submission/submission.hpp"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace cd {

Coordinator::Coordinator(CoordinatorParts parts)
    : parts_(std::move(parts)),
      state_(parts_,
             {worker_desk_,
              [this](const Action& action) { perform(action); },
              [this] { services_.work.feed(); }}),
      services_(parts_, state_),
      worker_desk_(state_, services_, parts_.options.times.heartbeat),
      job_desk_(state_, services_, parts_.geometry) {}

// ---- Restart -----------------------------------------------------------------------------------

Status Coordinator::restore(Recovered recovered) {
    cluster_ = recovered.cluster;
    state_.alarms.restore(std::move(recovered.alarms));
    Authors known;
    state_.jobs.reserve(recovered.last_job);
    for (RecoveredJob& found : recovered.jobs) {
        MasterJob& job = state_.jobs.add(MasterJob(std::move(found), state_.loop.now()));
        job.meshes = parts_.geometry.hold(meshes_of(job.submit));
        if (!job.is_running()) {
            continue;
        }
        if (const Status restored = restore_run(job, found, known); !restored) {
            return restored;
        }
        services_.start.resume(job);
    }
    await_workers();
    state_.writer.start(journal_events());
    for (const auto& [process, author] : known) {
        for (const JobId job : state_.jobs.running()) {
            if (state_.alarms.is_quarantined(process)) {
                services_.quarantine.withdraw_results(*author, state_.jobs.at(job));
            }
        }
    }
    return Done{};
}

Status Coordinator::restore_run(MasterJob& job, RecoveredJob& found, Authors& known) {
    const auto poses = open_poses(job.submit, parts_.journal.poses_path(job.id));
    if (!poses) {
        return with_remedy(poses.error());
    }
    job.run->poses = poses.value();
    state_.writer.restore(job.id, found.done);
    const auto author_of = [&](InstanceId process) {
        std::shared_ptr<const Author>& author = known[process];
        if (author == nullptr && process != 0) {
            author = std::make_shared<const Author>(Author{process, {}, {}, {}});
        }
        return author;
    };
    for (std::size_t i = 0; i < found.done.size(); ++i) {
        job.merged.restore(
            found.done[i].scenario, found.done[i].facts, author_of(found.authors[i]));
    }
    for (const Remark& open : found.disputes) {
        job.run->disputes_before.push_back(
            {job.id, open.scenario, author_of(open.author), open.digest});
    }
    job.run->disputes = found.disputes.size();
    log_info("job goes on: job={} name=\"{}\" done={} scenarios={}",
             job.id.value,
             job.submit.name,
             found.done.size(),
             job.submit.scenarios);
    return Done{};
}

void Coordinator::await_workers() {
    std::set<JobId> jobs = state_.jobs.running();
    std::set<InstanceId> processes;
    for (const JobId id : jobs) {
        processes.merge(state_.jobs.at(id).merged.processes());
    }
    std::erase_if(processes, [this](InstanceId one) { return state_.alarms.is_quarantined(one); });
    const FailureTimes::Duration within = parts_.options.times.return_within;
    state_.awaited =
        AwaitedWorkers(std::move(jobs), std::move(processes), state_.loop.now() + within);
    if (state_.awaited.size() != 0) {
        log_info("jobs wait for workers to come back: workers={} seconds_max={:.3f}",
                 state_.awaited.size(),
                 std::chrono::duration<double>(within).count());
        state_.loop.after(within, [this] { services_.work.feed(); });
    }
}

void Coordinator::close() {
    is_closed_ = true;
    state_.workers.close();
    state_.blocks.close();
    state_.loop.close();
    state_.retries.close();
    services_.references.close();
}

// ---- Events of the journal ---------------------------------------------------------------------

JournalWriter::Events Coordinator::journal_events() {
    return {[this](WorkerId worker, const ResultsKept& kept) {
                if (const Worker* here = state_.workers.find(worker)) {
                    here->channel->send(kept);
                }
            },
            [this](JobId job) { state_.waits.wake(job); },
            [this](JobId job) { job_ended(job); },
            [this](JobId job) { job_dropped(job); },
            [this](const Dispute& dispute) { services_.arbiter.settle(dispute); },
            [this] {
                for (const JobId job : state_.jobs.running()) {
                    ++state_.jobs.at(job).changes;
                }
                services_.work.feed();
            },
            [this] { services_.work.feed(); }};
}

void Coordinator::job_ended(JobId id) {
    MasterJob& job = state_.jobs.at(id);
    job.results->close();
    for (const JobId dropped : state_.jobs.announce(job)) {
        state_.writer.write(DropJob{dropped});
    }
    const JobStatus status = job.status(state_.loop.now());
    log_info("job ended: job={} state={} merged={} total={} seconds={:.3f} recalled={} copies={} "
             "copies_won={} digest={}{}",
             id.value,
             to_text(status.state),
             status.summary.merged(),
             status.summary.total,
             status.seconds,
             status.recalled,
             status.copies,
             status.copies_won,
             status.digest ? to_short_hex(*status.digest) : "none",
             status.failure.empty() ? "" : " reason=\"" + status.failure + "\"");
    state_.waits.wake(id);
    services_.ingest.take_up(id);
}

void Coordinator::job_dropped(JobId job) {
    state_.background.block(
        [files = parts_.journal.files_of(job)] {
            std::error_code ignored; // A leftover file does no harm.
            for (const auto& path : files) {
                std::filesystem::remove(path, ignored);
            }
            return Done{};
        },
        [](Done /*removed*/) {});
    state_.waits.wake(job);
}

// ---- The dispatcher's actions ------------------------------------------------------------------

void Coordinator::perform(const Action& action) {
    std::visit(
        [this](const auto& one) {
            using One = std::decay_t<decltype(one)>;
            if constexpr (std::is_same_v<One, GiveUp>) {
                give_up(one);
            } else if constexpr (std::is_same_v<One, PositionsLost>) {
                services_.ranges.lost(one);
            } else {
                services_.tasks.send(one);
            }
        },
        action);
}

void Coordinator::give_up(const GiveUp& action) {
    MasterJob* job = state_.jobs.find_running(action.job);
    if (job == nullptr) {
        return;
    }
    const auto analysis = job->work()->open.find(action.position);
    CD_CHECK(analysis != nullptr);
    log_error("scenario given up: job={} scenario={}", job->id.value, analysis->scenario.index);
    services_.merger.fail(*job,
                          {analysis->scenario, analysis->position},
                          "lost with " + std::to_string(limits::scenario_losses_max) +
                              " workers, one after the other, or with fewer again and again");
}

void Coordinator::check_invariants() const {
    cd::check_invariants(state_, services_);
    CD_CHECK(state_.workers.all().empty() || is_closed_ || worker_desk_.is_watching());
}

} // namespace cd
