// Settles disputes: two results of one scenario differ, and the master's own run decides. Each
// duplicate result is thus a free test of memory and code.
//
// A dispute is journaled before the result is acknowledged. The first entry that follows from a
// verdict has the alarm and the quarantine. A restarted master therefore finds either the open
// dispute or the quarantine, and then withdraws what is left of the process's results.
#pragma once

#include "master/compute/reference_run.hpp"
#include "master/dispatch/dispatch_driver.hpp"
#include "master/jobs/job_life.hpp"
#include "master/jobs/job_merger.hpp"
#include "master/jobs/job_table.hpp"
#include "master/verify/alarms.hpp"
#include "master/verify/quarantine.hpp"

#include <memory>
#include <optional>
#include <string>

namespace cd {

/// What follows when two results of a scenario differ.
struct Verdict {
    bool first_is_wrong = false;  ///< The merged result has to be corrected.
    bool second_is_wrong = false; ///< The process that gave the other result was wrong.
};

/// Compares the merged result, `merged`, and the one in dispute, `second`, with the right one.
/// `merged` is empty if there is none, or if it is the master's own failure.
[[nodiscard]] Verdict
judge(const std::optional<Sha256>& merged, const Sha256& second, const Sha256& right);

class Arbiter {
  public:
    struct Parts {
        JobTable& jobs;
        JobLife& life;
        DispatchDriver& dispatch;
        ReferenceRuns& references;
        Alarms& alarms;
        Quarantine& quarantine;
        JournalWriter& writer;
    };

    /// All parts outlive it.
    explicit Arbiter(const Parts& parts) : parts_(parts) {}

    /// Runs the scenario, and settles the dispute. Does nothing if the job has ended.
    void settle(const Dispute& dispute);

  private:
    void ran(const Dispute& dispute, Result<ReferenceResult> found);
    void close(MasterJob& job, const Dispute& dispute, ReferenceResult right);
    /// Raises alarms and quarantines.
    void punish(const MasterJob& job, const Dispute& dispute, const Verdict& verdict);

    Parts parts_;
};

} // namespace cd
