// Settles disputes: two results of one scenario differ, and the master's own run decides. Each
// duplicate result is thus a free test of memory and code.
//
// The journal has the dispute before the second result is acknowledged. The first journal entry
// after a verdict contains the alarm and the quarantine. A restarted master therefore finds either
// the open dispute, or the quarantine, and then withdraws the process's remaining results.
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

/// Says which of two different results of a scenario is wrong.
struct Verdict {
    bool first_is_wrong = false;  ///< The merged result has to be corrected.
    bool second_is_wrong = false; ///< The later result, which was not merged, is wrong.
};

/// Compares the digests of the merged result and of the later one, `second`, with the right one.
/// `merged` is empty if the scenario has no merged result, or the master has failed it.
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

    /// All parts outlive this object.
    explicit Arbiter(const Parts& parts) : parts_(parts) {}

    /// Runs the scenario on the master, and settles the dispute. Does nothing if the job has ended.
    void settle(const Dispute& dispute);

  private:
    void ran(const Dispute& dispute, Result<ReferenceResult> found);
    void close(MasterJob& job, const Dispute& dispute, ReferenceResult right);
    /// Raises an alarm for each wrong result, and quarantines its author.
    void punish(const MasterJob& job, const Dispute& dispute, const Verdict& verdict);

    Parts parts_;
};

} // namespace cd
