// Identity of a worker process across its sessions, and counts of the processes that were lost with
// a scenario.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cd {

/// Identifies a worker process by its random number (`Hello::instance`). 0: the master, or
/// unknown.
using InstanceId = std::uint64_t;

/// A session of a worker as the author of results.
struct Author {
    InstanceId process = 0;
    WorkerId worker;        ///< 0: the session is from before a restart of the master.
    std::string name;       ///< Empty for a session from before a restart, like `holder`.
    std::string holder;     ///< Holder of the worker's certificate; empty without one.
    std::string build = {}; ///< Version of the worker's program; empty like `name`.

    /// For example "sim-7 (w-3, certified as sim)".
    [[nodiscard]] std::string to_text() const {
        if (worker == WorkerId{}) {
            return "a worker of an earlier run of the master";
        }
        return name + " (w-" + std::to_string(worker.value) +
               (holder.empty() ? ")" : ", certified as " + holder + ")");
    }
};

/// Counts how often a scenario was lost with a worker. A process that is lost repeatedly has
/// returned, so the scenario did not kill it, and it counts once. But on a cluster of one host, a
/// scenario that silences the host each time would then never be given up. So every
/// `limits::losses_again_that_count`-th repeated loss counts as well.
class Losses {
  public:
    /// Adds a loss with the process. Process 0 (unknown, or still connected) counts each time.
    void add(InstanceId process) {
        const bool is_known =
            process != 0 && std::ranges::find(processes_, process) != processes_.end();
        if (is_known && ++again_ % limits::losses_again_that_count != 0) {
            return;
        }
        if (!is_known && count_ < processes_.size()) {
            processes_[count_] = process;
        }
        ++count_;
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// True if the scenario was never lost, so that a task with a range may contain it.
    [[nodiscard]] bool none() const { return count_ == 0; }

    friend bool operator==(const Losses&, const Losses&) = default;

  private:
    std::array<InstanceId, limits::scenario_losses_max> processes_{};
    std::size_t count_ = 0;
    std::size_t again_ = 0; ///< Number of losses with processes that were lost before.
};

/// Consecutive positions in a job's hand-out order that were lost together with a process.
struct LostPositions {
    PositionRange positions;
    InstanceId process = 0; ///< Argument for `Losses::add`.

    friend bool operator==(const LostPositions&, const LostPositions&) = default;
};

} // namespace cd
