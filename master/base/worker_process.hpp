// Identity of a worker process across its sessions, and the processes that scenarios were lost
// with.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// A worker process, identified by its random number (`Hello::instance`). 0: the master, or
/// unknown.
using WorkerProcess = std::uint64_t;

/// Counts the losses of scenarios by process. A process that returns was not killed by them, so it
/// counts once. A scenario that silences its host each time would never be given up on a cluster of
/// one host, so every `limits::losses_again_that_count`-th repeated loss counts, too.
class Losses {
  public:
    /// Marks scenarios whose results are suspect; they were not lost.
    [[nodiscard]] static Losses in_doubt() {
        Losses losses;
        losses.in_doubt_ = true;
        return losses;
    }
    /// 0: an unknown process or one that is still connected; it counts each time.
    void add(WorkerProcess process) {
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
    [[nodiscard]] bool are_in_doubt() const { return in_doubt_; }
    /// The scenarios may be handed out in bulk.
    [[nodiscard]] bool none() const { return count_ == 0 && !in_doubt_; }

    friend bool operator==(const Losses&, const Losses&) = default;

  private:
    std::array<WorkerProcess, limits::scenario_losses_max> processes_{};
    std::size_t count_ = 0;
    std::size_t again_ = 0; ///< Repeated losses with known processes.
    bool in_doubt_ = false;
};

/// Consecutive order positions of a job, lost together.
struct LostPlaces {
    PlaceRange places;
    WorkerProcess process = 0; ///< As in `Losses::add`.

    friend bool operator==(const LostPlaces&, const LostPlaces&) = default;
};

} // namespace cd
