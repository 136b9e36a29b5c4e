// A worker's process, whatever its sessions, and with which ones a scenario was lost.
#pragma once

#include "common/core/limits/master.hpp"
#include "common/job/poses/ordered_poses.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace cd {

/// A process of a worker, by the number that it drew (`Hello::instance`). 0: the master, or nobody
/// knows.
using WorkerProcess = std::uint64_t;

/// Of scenarios: with whom they were lost. A process that comes back was not killed by them, and
/// counts once. But what silences its host each time would never come to an end where there are no
/// others: so after so many more losses it counts again.
class Losses {
  public:
    /// Of scenarios that were not lost: their results are in doubt.
    [[nodiscard]] static Losses in_doubt() {
        Losses losses;
        losses.in_doubt_ = true;
        return losses;
    }
    /// 0: one that nobody knows, or that is still here; it counts each time.
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
    /// Nothing speaks against handing them out many at a time.
    [[nodiscard]] bool none() const { return count_ == 0 && !in_doubt_; }

    friend bool operator==(const Losses&, const Losses&) = default;

  private:
    std::array<WorkerProcess, limits::scenario_losses_max> processes_{};
    std::size_t count_ = 0;
    std::size_t again_ = 0; ///< With those that are known.
    bool in_doubt_ = false;
};

/// Consecutive places of a job, lost together.
struct LostPlaces {
    PlaceRange places;
    WorkerProcess process = 0; ///< As `Losses::add` takes it.

    friend bool operator==(const LostPlaces&, const LostPlaces&) = default;
};

} // namespace cd
