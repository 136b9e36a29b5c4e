// Analyses the next scenarios of jobs: merges the results that the analysis finds, and gives the
// other scenarios to the dispatcher.
#pragma once

#include "common/core/limits/engine.hpp"
#include "master/base/background.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_merger.hpp"
#include "master/jobs/job_table.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// Bounds on the analyses that are ahead of the workers. A simulation of the paper's master lowers
/// them.
struct FeedLimits {
    /// Scenarios that a pool thread analyses together; at most `limits::analysis_block_scenarios`.
    std::uint64_t block_scenarios = limits::analysis_block_scenarios;
    /// Analysed scenarios that may wait outside the workers' buffers; 0: the dispatcher decides.
    std::uint64_t waiting_max = 0;
};

class AnalysisFeed {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        JobMerger& merger;
        DispatchDriver& dispatch;
        Background& background;
        FeedLimits limits;
    };

    /// All parts outlive the feed.
    explicit AnalysisFeed(const Parts& parts) : parts_(parts) {}

    /// Starts the analysis of the next positions of a job, whose queue must not be empty.
    void start(MasterJob& job);

  private:
    [[nodiscard]] std::unique_ptr<Analyser> make_analyser(const MasterJob& job);
    /// Takes an analysed block. `finished`: results of its scenarios that need no worker.
    void came(JobId job, AnalysedBlock block, TakenResults finished);
    struct HandedOut {
        std::uint64_t scenarios = 0;
        double added_bytes = 0; ///< What the analysis adds to them on the wire.
    };
    /// Gives the dispatcher the scenarios that need a worker. Skips scenarios with a result, for
    /// example one that a worker delivered after a restart.
    HandedOut hand_out(MasterJob& job, AnalysedBlock& block);

    Parts parts_;
};

} // namespace cd
