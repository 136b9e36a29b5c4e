#include "master/jobs/job_start.hpp"

#include "common/core/host/log.hpp"
#include "master/dispatch/policy/strategies.hpp"
#include "master/submission/submission.hpp"

#include <utility>
#include <vector>

namespace cd {

void JobStart::begin(const JobRecord& record,
                     std::shared_ptr<ResultStore> results,
                     std::shared_ptr<OrderedPoses> poses) {
    const Submit& submit = record.submit;
    MasterJob& job =
        parts_.jobs.add(MasterJob(record.id, submit, std::move(results), parts_.jobs.now()));
    job.times.began = record.began;
    job.meshes = parts_.geometry.hold(meshes_of(submit));
    job.run->poses = std::move(poses);
    log_info("job accepted: job={} name=\"{}\" scenarios={} strategy={}",
             job.id.value,
             submit.name,
             submit.scenarios,
             submit.cluster.strategy);
    prepare(job);
}

void JobStart::prepare(const MasterJob& job) {
    parts_.background.block(
        [&geometry = parts_.geometry, submit = job.submit] { return geometry.prepare(submit); },
        [this, id = job.id](const StoreResult<JobGeometry>& made) { prepared(id, made); });
}

void JobStart::prepared(JobId id, const StoreResult<JobGeometry>& made) {
    MasterJob* job = parts_.jobs.find_running(id);
    if (job == nullptr) {
        return; // The job was cancelled meanwhile.
    }
    if (const Status known = check_strategy(job->submit.cluster.strategy); !known) {
        // Another build of cdmaster, which knows the strategy, accepted the job.
        return parts_.life.end(*job, JobState::Failed, known.error().detail);
    }
    if (made) {
        parts_.life.disk_gives(*job);
        return open(*job, made.value());
    }
    const Error& why = made.error();
    const bool may_be_mended = made.is_unwritten() || why.code == ErrorCode::NotFound;
    parts_.life.wait_for_disk(*job,
                              may_be_mended ? Error{ErrorCode::Io, why.detail} : why,
                              [this](const MasterJob* running) {
                                  if (running != nullptr) {
                                      prepare(*running);
                                  }
                              });
}

void JobStart::open(MasterJob& job, const JobGeometry& made) {
    const Submit& submit = job.submit;
    job.run->work = std::make_unique<JobWork>();
    JobWork& work = *job.run->work;
    work.analysis_input = made.analysis;
    work.analysis_input.poses = job.run->poses;
    work.material = made.material;
    work.todo = PositionQueue(job.run->poses->count(), std::exchange(job.run->losses_before, {}));
    job.tally.depths.clear();
    for (std::size_t body = 0; body < made.cuts.size(); ++body) {
        work.trees.push_back(parts_.trees.acquire(submit.bodies[body].mesh, made.cuts[body]));
        job.tally.depths.push_back(made.cuts[body]->depth());
    }
    const std::vector<AddTree> in_use = parts_.trees.messages();
    for (auto& [id, worker] : parts_.workers.all()) {
        if (worker.is_settled && !worker.is_quarantined) {
            worker.send(worker.supply.add_kept(in_use));
        }
    }
    const std::string owner = parts_.knows_owners ? submit.owner : std::string();
    parts_.dispatch.act(parts_.dispatch->job_opened(
        job.id, submit.cluster, dispatch_trees(work.trees, made.cuts), {submit.priority, owner}));
    started_(job);
    parts_.life.end_if_complete(job); // The job may have no scenarios, or none left.
}

} // namespace cd
