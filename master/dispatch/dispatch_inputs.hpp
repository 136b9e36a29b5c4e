// Facts that the owner reports to the dispatcher.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "common/tree/cut.hpp"
#include "master/base/instance_id.hpp"
#include "master/dispatch/policy/strategies.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A scenario that needs a worker: it has at least one pair of colliding roots.
struct AnalysedScenario {
    std::uint64_t index = 0;
    std::vector<RootIndex> roots_a; ///< Ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< Size that the scenario adds to a batch on the wire.
    /// Predicted time on one thread, 0 if unknown; only ratios between scenarios matter.
    std::uint64_t predicted_ns = 0;
    /// Losses before this analysis: in ranges, or before a restart of the master.
    Losses losses = {};
};

/// Time that a worker's threads spent on answered scenarios of a task.
struct MeasuredWork {
    TaskId task;
    std::uint64_t predicted_ns = 0; ///< Sum of the scenarios' predictions.
    double seconds = 0;             ///< Measured, summed over the threads.
};

struct DispatcherOptions {
    bool helps_at_end = true; ///< False: never recall or copy work.
    /// With more than `workers_few` workers, a change triggers a check of all workers at most every
    /// `look_seconds_each` seconds per worker above that number.
    std::size_t workers_few = limits::workers_few;
    double look_seconds_each = timing::look_seconds_each;
    std::span<const RegisteredStrategy> strategies = registered_strategies();

    /// Minimum time between two checks of so many workers, s.
    [[nodiscard]] double look_seconds(std::size_t workers) const {
        const std::size_t beyond = workers - std::min(workers, workers_few);
        return look_seconds_each * static_cast<double>(beyond);
    }
};

} // namespace cd
