// Identity of a worker process across its sessions, and the processes that scenarios were lost
// with.
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

/// A worker process, identified by its random number (`Hello::instance`). 0: the master, or
/// unknown.
using InstanceId = std::uint64_t;

/// A session of a worker as the author of results.
struct Author {
    InstanceId process = 0;
    WorkerId worker;    ///< 0: the session belongs to an earlier incarnation of the master.
    std::string name;   ///< Empty for an earlier session, like `holder`.
    std::string holder; ///< Holder of its certificate; empty without one.

    /// "sim-7 (w-3, certified as sim)".
    [[nodiscard]] std::string to_text() const {
        if (worker == WorkerId{}) {
            return "a worker of an earlier run of the master";
        }
        return name + " (w-" + std::to_string(worker.value) +
               (holder.empty() ? ")" : ", certified as " + holder + ")");
    }
};

/// Counts the losses of scenarios by process. A process that returns was not killed by them, so it
/// counts once. A scenario that silences its host each time would never be given up on a cluster of
/// one host, so every `limits::losses_again_that_count`-th repeated loss counts, too.
class Losses {
  public:
    /// 0: an unknown process or one that is still connected; it counts each time.
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
    /// The scenarios may be handed out in bulk.
    [[nodiscard]] bool none() const { return count_ == 0; }

    friend bool operator==(const Losses&, const Losses&) = default;

  private:
    std::array<InstanceId, limits::scenario_losses_max> processes_{};
    std::size_t count_ = 0;
    std::size_t again_ = 0; ///< Repeated losses with known processes.
};

/// Consecutive order positions of a job, lost together.
struct LostPlaces {
    PlaceRange places;
    InstanceId process = 0; ///< As in `Losses::add`.

    friend bool operator==(const LostPlaces&, const LostPlaces&) = default;
};

} // namespace cd
