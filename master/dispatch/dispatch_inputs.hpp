// Facts that the owner reports to the dispatcher.
#pragma once

#include "common/core/id.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/tree/cut.hpp"
#include "master/base/instance_id.hpp"
#include "master/base/position_set.hpp"
#include "master/dispatch/policy/strategies.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// A scenario that needs a worker: it has at least one pair of colliding roots.
struct AnalysedScenario {
    std::uint64_t position = 0;     ///< In the job's hand-out order.
    std::vector<RootIndex> roots_a; ///< Ascending.
    std::vector<RootIndex> roots_b;
    std::uint64_t bytes = 0; ///< Size that the scenario adds to a batch on the wire.
    /// Predicted time on one thread, 0 if unknown; only ratios between scenarios matter.
    std::uint64_t predicted_ns = 0;
    /// Losses of the scenario before its analysis: in ranges, or before a restart of the master.
    Losses losses = {};
    std::uint32_t body_a = 0; ///< Index in the job's list of bodies.
    std::uint32_t body_b = 1;
};

/// Positions in a job's hand-out order that may go out without analysis.
struct GivenRange {
    PositionRange positions;
    std::shared_ptr<const PoseWindow> window = {}; ///< Poses of the positions; null on a grid.

    friend bool operator==(const GivenRange&, const GivenRange&) = default;
};

/// Answers of a worker or of the master.
struct Answers {
    WorkerId worker; ///< 0: the master.
    TaskId task;     ///< Task of the worker that had the positions; 0 if unknown.
    JobId job;
    PositionSet positions;
    double busy_seconds = 0;    ///< Thread time of the worker for the answers, s; 0: not measured.
    std::uint64_t repeated = 0; ///< Number of positions that have been answered before.
};

struct DispatcherOptions {
    bool helps_at_end = true; ///< False: never recall or copy work.
    /// With more than `workers_few` workers, a change triggers a check of all workers at most every
    /// `look_seconds_each` seconds per worker above that number.
    std::size_t workers_few = limits::workers_few;
    double look_seconds_each = timing::look_seconds_each;
    std::span<const RegisteredStrategy> strategies = registered_strategies();

    /// Minimum time between two checks of all workers, if there are `workers` of them, s.
    [[nodiscard]] double look_seconds(std::size_t workers) const {
        const std::size_t beyond = workers - std::min(workers, workers_few);
        return look_seconds_each * static_cast<double>(beyond);
    }
};

} // namespace cd
