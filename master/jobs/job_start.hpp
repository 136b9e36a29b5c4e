// Starts jobs: loads their geometry on the thread pool, and then opens them for work.
#pragma once

#include "master/base/background.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/geometry/tree_registry.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_table.hpp"
#include "master/workers/worker_directory.hpp"

#include <functional>
#include <memory>

namespace cd {

class JobStart {
  public:
    struct Parts {
        Geometry& geometry;
        JobTable& jobs;
        JobLife& life;
        WorkerDirectory& workers;
        TreeRegistry& trees;
        DispatchDriver& dispatch;
        Background& background;
        /// True if a job's owner is the holder of a certificate. Otherwise clients name themselves
        /// as they like, and all jobs count as one owner's.
        bool knows_owners = false;
    };

    /// All parts outlive this object. `started` is called when a job is open for work.
    JobStart(const Parts& parts, std::function<void(MasterJob&)> started)
        : parts_(parts), started_(std::move(started)) {}

    /// Starts a new job, which the journal has committed.
    void begin(const JobRecord& record,
               std::shared_ptr<ResultStore> results,
               std::shared_ptr<OrderedPoses> poses);
    /// Continues a job after a restart of the master. Its results must be merged already.
    void resume(MasterJob& job) { prepare(job); }

  private:
    void prepare(const MasterJob& job);
    void prepared(JobId job, const StoreResult<JobGeometry>& made);
    void open(MasterJob& job, const JobGeometry& made);

    Parts parts_;
    std::function<void(MasterJob&)> started_;
};

} // namespace cd
