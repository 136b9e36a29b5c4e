// Analyses the next scenarios of jobs: merges those that the analysis answers, and gives the others
// to the dispatcher.
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

    /// Starts the analysis of the next positions of a job, whose queue must not be empty.
    void start(MasterJob& job);

  private:
    [[nodiscard]] std::unique_ptr<Analyser> make_analyser(const MasterJob& job);
    /// Takes analysed scenarios. `finished`: the results of those that need no worker.
    void came(JobId job, AnalysedBlock block, std::vector<TakenResult> finished);
    /// Gives the dispatcher the scenarios that need a worker, and returns their number. Skips those
    /// with a result, for example one that a worker delivered again after a restart.
    std::uint64_t hand_out(MasterJob& job, AnalysedBlock& block);

    Parts parts_;
};

} // namespace cd
