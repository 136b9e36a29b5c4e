// The services of the master, which process jobs, tasks and results.
#pragma once

#include "master/compute/reference_run.hpp"
#include "master/coordinator/master_state.hpp"
#include "master/jobs/feed/analysis_feed.hpp"
#include "master/jobs/feed/range_feed.hpp"
#include "master/jobs/feed/task_exchange.hpp"
#include "master/jobs/feed/work_feed.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_merger.hpp"
#include "master/jobs/job_start.hpp"
#include "master/results/result_ingest.hpp"
#include "master/verify/arbiter.hpp"
#include "master/verify/quarantine.hpp"

namespace cd {

/// Each service may use those declared above it. In the other direction, services call callbacks.
struct MasterServices {
    /// Parts and state outlive the services.
    MasterServices(const CoordinatorParts& parts, MasterState& state);
    MasterServices(const MasterServices&) = delete;
    MasterServices& operator=(const MasterServices&) = delete;

    ReferenceRuns references;
    JobLife life;
    JobMerger merger;
    TaskExchange tasks;
    RangeFeed ranges;
    AnalysisFeed analyses;
    WorkFeed work;
    Quarantine quarantine;
    Arbiter arbiter;
    ResultIngest ingest;
    JobStart start;

  private:
    /// Called when a job is open for work: processes its waiting results and disputes.
    void started(MasterJob& job);
};

} // namespace cd
