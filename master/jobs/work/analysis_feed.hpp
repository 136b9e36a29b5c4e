// Analyses the next scenarios of jobs, and gives those that need a worker to the dispatcher.
#pragma once

#include "master/base/background.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_merger.hpp"
#include "master/jobs/job_table.hpp"

#include <vector>

namespace cd {

class AnalysisFeed {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        JobMerger& merger;
        DispatchDriver& dispatch;
        Background& background;
    };

    /// All parts outlive the feed.
    explicit AnalysisFeed(const Parts& parts) : parts_(parts) {}

    /// Starts the analysis of the next positions of a job that has some to hand out.
    void start(MasterJob& job);

  private:
    /// Skips scenarios that already have a result, for example those that workers delivered again
    /// after a restart.
    [[nodiscard]] std::unique_ptr<Analyser> make_analyser(const MasterJob& job);
    void came(JobId job, AnalysedBlock block, std::vector<TakenResult> finished);
    /// Gives the dispatcher what needs a worker. Returns the number of scenarios.
    std::uint64_t hand_out(MasterJob& job, AnalysedBlock& block);

    Parts parts_;
};

} // namespace cd
