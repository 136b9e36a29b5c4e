// Job life cycle in the coordinator: prepare, start, end, cancel.
#include "common/core/host/log.hpp"
#include "common/core/host/wall_clock.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/run_scenario.hpp"
#include "master/base/remedy.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/submission/submission.hpp"

#include <algorithm>

namespace cd {

Status Coordinator::restore(Recovered recovered) {
    cluster_ = recovered.cluster;
    alarms_.restore(std::move(recovered.alarms));
    std::map<InstanceId, std::shared_ptr<const Author>> known;
    jobs_.reserve(recovered.last_job);
    for (RecoveredJob& found : recovered.jobs) {
        const std::vector<ResultRow> done = std::move(found.done);
        const std::vector<InstanceId> authors = std::move(found.authors);
        const std::vector<Remark> disputes = std::move(found.disputes);
        MasterJob& job = jobs_.add(MasterJob(std::move(found), Clock::now()));
        job.meshes = parts_.geometry.hold(meshes_of(job.submit));
        if (!job.is_running()) {
            continue;
        }
        const auto poses = open_poses(job.submit, parts_.journal.poses_path(job.id));
        if (!poses) {
            return with_remedy(poses.error());
        }
        job.poses = poses.value();
        writer_.restore(job.id, done);
        const auto author_of = [&](InstanceId process) {
            std::shared_ptr<const Author>& author = known[process];
            if (author == nullptr && process != 0) {
                author = std::make_shared<const Author>(Author{process, {}, {}, {}});
            }
            return author;
        };
        for (std::size_t i = 0; i < done.size(); ++i) {
            job.merged.restore(done[i].scenario, done[i].facts, author_of(authors[i]));
        }
        for (const Remark& open : disputes) {
            job.disputes_left.push_back(
                {job.id, open.scenario, author_of(open.author), open.digest});
        }
        job.disputes = job.disputes_left.size();
        log_info("job goes on: job={} name=\"{}\" done={} scenarios={}",
                 job.id.value,
                 job.submit.name,
                 done.size(),
                 job.submit.scenarios);
        prepare_job(job);
    }
    await_workers();
    writer_.start(journal_events());
    for (const auto& [process, author] : known) {
        for (const JobId job : jobs_.running()) {
            if (alarms_.is_quarantined(process)) {
                withdraw_results_of(*author, *jobs_.find(job));
            }
        }
    }
    return Done{};
}

void Coordinator::await_workers() {
    std::set<JobId> jobs;
    std::set<InstanceId> processes;
    for (const JobId id : jobs_.running()) {
        jobs.insert(id);
        processes.merge(jobs_.at(id).merged.processes());
    }
    std::erase_if(processes, [this](InstanceId one) { return alarms_.is_quarantined(one); });
    const auto until = Clock::now() + parts_.times.return_within;
    awaited_ = AwaitedWorkers(std::move(jobs), std::move(processes), until);
    if (awaited_.size() != 0) {
        log_info("jobs wait for workers to come back: workers={} seconds_max={:.3f}",
                 awaited_.size(),
                 std::chrono::duration<double>(parts_.times.return_within).count());
        awaited_until_ = std::make_shared<asio::steady_timer>(parts_.executor, until);
        spawn(parts_.executor, "workers that come back", end_waiting(awaited_until_));
    }
}

asio::awaitable<void> Coordinator::end_waiting(std::shared_ptr<asio::steady_timer> timer) {
    boost::system::error_code ignored;
    co_await timer->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    if (!closed_) {
        feed();
    }
}

Result<JobId> Coordinator::allot_job(std::uint64_t scenarios) {
    if (!writer_.paused().empty()) {
        return Error{ErrorCode::Io, "the master takes no jobs now: " + writer_.paused()};
    }
    return jobs_.next(scenarios);
}

void Coordinator::begin_job(const JobRecord& record,
                            std::shared_ptr<ResultStore> results,
                            std::shared_ptr<PoseSource> poses) {
    const Submit& submit = record.submit;
    MasterJob& job = jobs_.add(MasterJob(record.id, submit, std::move(results), Clock::now()));
    job.began = record.began;
    job.meshes = parts_.geometry.hold(meshes_of(submit));
    job.poses = std::move(poses);
    log_info("job accepted: job={} name=\"{}\" scenarios={} strategy={}",
             job.id.value,
             submit.name,
             submit.scenarios,
             to_text(submit.cluster.strategy));
    prepare_job(job);
}

void Coordinator::prepare_job(const MasterJob& job) {
    parts_.blocking.post([this,
                          executor = parts_.executor,
                          &store = parts_.geometry,
                          id = job.id,
                          submit = job.submit] {
        const auto made =
            std::make_shared<const StoreResult<JobGeometry>>(make_job_geometry(store, submit));
        asio::post(executor, [this, id, made] { job_prepared(id, *made); });
    });
}

void Coordinator::job_prepared(JobId id, const StoreResult<JobGeometry>& made) {
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        return; // The job was cancelled meanwhile.
    }
    if (made) {
        job_paused(*job, "");
        return start_job(*job, made.value());
    }
    const Error& why = made.error();
    const bool may_be_mended = made.is_unwritten() || why.code == ErrorCode::NotFound;
    wait_for_disk(*job,
                  may_be_mended ? Error{ErrorCode::Io, why.detail} : why,
                  [this](const MasterJob* running) {
                      if (running != nullptr) {
                          prepare_job(*running);
                      }
                  });
}

void Coordinator::start_job(MasterJob& job, const JobGeometry& made) {
    const Submit& submit = job.submit;
    AnalysisInput input = make_analysis_input(made, submit.query, job.poses);
    job.material = std::make_shared<const JobMaterial>(
        JobMaterial{made.tree_a, made.tree_b, submit.query, input.settler});
    job.tree_a = trees_.acquire(submit.bodies[0].mesh, made.cut_a);
    job.tree_b = trees_.acquire(submit.bodies[1].mesh, made.cut_b);
    job.depths = {made.cut_a->depth(), made.cut_b->depth()};
    const std::vector<AddTree> in_use = trees_.messages();
    for (auto& [id, worker] : workers_.all()) {
        if (worker.is_settled && !worker.is_quarantined) {
            worker.send(worker.supply.add_kept(in_use));
        }
    }
    job.analysis_input = input;
    job.order = std::make_shared<OrderedPoses>(std::move(input.poses));
    job.todo = PlaceQueue(job.order->count(), std::exchange(job.losses_before, {}));
    act(dispatcher().job_opened(job.id,
                                submit.cluster,
                                dispatch_tree(job.tree_a, *made.cut_a),
                                dispatch_tree(job.tree_b, *made.cut_b)));
    look_at_late_results(job.id);
    for (const Dispute& dispute : std::exchange(job.disputes_left, {})) {
        run_disputed(dispute);
    }
    end_if_complete(job); // The job may have no scenarios, or none left.
    feed();
}

void Coordinator::begin_analysis(MasterJob& job) {
    AnalysisInput input = *job.analysis_input;
    input.poses = job.order;
    // Runs on a pool thread and makes the records there.
    auto deliver = [this, executor = parts_.executor, id = job.id](AnalysedBlock came) {
        auto finished = std::make_shared<std::vector<TakenResult>>();
        for (Analysis& analysis : came.scenarios) {
            if (analysis.finished) {
                finished->push_back(take_result(std::move(*analysis.finished), analysis.cost));
            }
        }
        auto block = std::make_shared<AnalysedBlock>(std::move(came));
        asio::post(executor, [this, id, block, finished] {
            block_came(id, std::move(*block), std::move(*finished));
        });
    };
    job.analyser = std::make_unique<Analyser>(parts_.compute, std::move(input), std::move(deliver));
}

void Coordinator::block_came(JobId id, AnalysedBlock block, std::vector<TakenResult> finished) {
    MasterJob* job = jobs_.find_running(id);
    if (job == nullptr) {
        return;
    }
    if (block.error) {
        job->todo.put_back({block.places, block.losses});
        wait_for_disk(*job, *block.error, [](MasterJob*) {});
        return feed();
    }
    disk_gives(*job);
    const auto begin = Clock::now();
    std::uint64_t handed_out = 0;
    for (Analysis& analysis : block.scenarios) {
        // A requeued or restored scenario may have been answered meanwhile.
        if (analysis.finished || job->merged.has(analysis.scenario.index) ||
            job->open.contains(analysis.scenario.index)) {
            continue;
        }
        AnalysedScenario scenario{analysis.scenario.index,
                                  std::move(analysis.roots_a),
                                  std::move(analysis.roots_b),
                                  analysis.bytes,
                                  analysis.predicted_ns,
                                  block.losses};
        open_bytes_ += analysis.bytes;
        job->open.emplace(scenario.index, std::make_shared<const Analysis>(std::move(analysis)));
        act(dispatcher().scenario_analysed(id, std::move(scenario)));
        if (!job->is_running()) {
            return feed();
        }
        ++handed_out;
    }
    job->analysis_seconds.add(block.seconds, static_cast<double>(block.places.count));
    if (handed_out != 0) {
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        job->matching_seconds.add(seconds, static_cast<double>(handed_out));
    }
    job->answered_by_master += static_cast<std::uint64_t>(std::ranges::count_if(
        finished, [&](const TakenResult& one) { return !job->merged.has(one.result.index); }));
    merge(*job, {std::move(finished), {}}, nullptr);
    end_if_complete(*job);
    feed();
}

void Coordinator::end_if_complete(MasterJob& job) {
    if (job.is_running() && job.disputes == 0 && job.merged.summary().is_complete()) {
        end_job(job, JobState::Done, "");
    }
}

void Coordinator::end_job(MasterJob& job, JobState state, const std::string& failure) {
    for (const auto& [index, analysis] : job.open) {
        open_bytes_ -= analysis->bytes;
    }
    const bool has_trees = job.material != nullptr;
    retries_.stop(job.id);
    (void)references_.stop(job.id, std::nullopt);
    jobs_.end(job, state, failure, Clock::now());
    act(dispatcher().job_closed(job.id));
    for (auto& [id, worker] : workers_.all()) {
        worker.send(worker.supply.remove_job(job.id));
    }
    if (has_trees) {
        release_tree(job.tree_a);
        release_tree(job.tree_b);
    }
    writer_.write(EndJob{job.id, *job.end, job.progress(Clock::now())});
}

void Coordinator::release_tree(TreeId tree) {
    if (!trees_.release(tree)) {
        return;
    }
    blocks_.tree_removed(tree);
    for (auto& [id, worker] : workers_.all()) {
        worker.meter.transfers().tree_removed(tree);
        worker.send(worker.supply.remove_tree(tree));
    }
}

// ---- Requests -----------------------------------------------------------------------------------

Explainer Coordinator::explainer() {
    return {
        jobs_, dispatcher(), [this](WorkerId worker) { return workers_.find(worker) != nullptr; }};
}

Result<JobStatus> Coordinator::cancel_job(JobId id) {
    MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (job->is_running()) {
        end_job(*job, JobState::Cancelled, "cancelled");
        feed();
    }
    return job_status(id);
}

Status Coordinator::forget_job(JobId id) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    if (job->state == JobState::Running) {
        return Error{ErrorCode::Refused, "the job is running"};
    }
    if (!writer_.paused().empty()) {
        return Error{ErrorCode::Io, "nothing can be removed now: " + writer_.paused()};
    }
    jobs_.drop(id);
    drop_from_journal(id);
    return Done{};
}

void Coordinator::forget_expired_jobs(std::uint64_t now) {
    if (!writer_.paused().empty()) {
        return;
    }
    for (const JobId job : jobs_.drop_expired(now)) {
        drop_from_journal(job);
    }
}

bool Coordinator::cancel_disputed(JobId job, std::uint64_t scenario) {
    if (!references_.stop(job, scenario)) {
        return false;
    }
    log_warning("scenario in dispute cancelled: job={} scenario={}", job.value, scenario);
    return true;
}

Result<std::shared_ptr<PoseSource>> Coordinator::poses_of_unanswered(JobId id,
                                                                     std::uint64_t scenario) {
    const MasterJob* job = jobs_.find(id);
    if (job == nullptr) {
        return no_job();
    }
    const std::string name = "scenario " + std::to_string(scenario);
    if (scenario >= job->merged.summary().total) {
        return Error{ErrorCode::NotFound, "the job has no " + name};
    }
    if (!job->is_running() || job->merged.has(scenario)) {
        return Error{ErrorCode::Refused, name + " has a result, or the job has ended"};
    }
    return job->poses;
}

Status Coordinator::cancel_scenario(JobId id, const Scenario& scenario) {
    if (const auto poses = poses_of_unanswered(id, scenario.index); !poses) {
        return poses.error();
    }
    log_warning("scenario cancelled: job={} scenario={}", id.value, scenario.index);
    fail_scenario(*jobs_.find(id), scenario, "cancelled");
    if (MasterJob* still = jobs_.find_running(id)) {
        still->cancelled.push_back(scenario.index);
        for (const auto& [known, worker] : workers_.all()) {
            if (worker.supply.has_job(id)) {
                worker.channel->send(DropScenario{id, scenario.index});
            }
        }
        act(dispatcher().scenario_answered(WorkerId{}, id, scenario.index));
    }
    feed();
    return Done{};
}

void Coordinator::fail_scenario(MasterJob& job, const Scenario& scenario, const std::string& why) {
    const Error error{ErrorCode::Interrupted, why};
    std::vector<TakenResult> taken;
    taken.push_back(take_result(failed_result(scenario, job.submit.query, error), {}));
    merge(job, {std::move(taken), {}}, nullptr);
    end_if_complete(job);
}

} // namespace cd
