// Actions that the dispatcher asks its owner to perform. A position is a scenario's place in the
// job's hand-out order.
#pragma once

#include "common/core/id.hpp"
#include "common/core/timing/master.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/tree/cut.hpp"
#include "master/base/instance_id.hpp"
#include "master/base/position_set.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace cd {

/// Asks the owner to send the positions to the worker as one task. Positions that are not analysed
/// are consecutive; the worker finds their colliding roots.
struct SendUnit {
    WorkerId worker;
    TaskId task;
    JobId job;
    PositionSet positions;
    bool is_analysed = true;
    TaskId copy_of = {}; ///< Another worker's task that has these positions; 0 if not a copy.
    std::shared_ptr<const PoseWindow> window = {}; ///< Poses of a range that is not on a grid.
    /// Time for which results may wait at the worker for others of the task, s.
    double results_wait_seconds = timing::results_wait_seconds_min;

    friend bool operator==(const SendUnit&, const SendUnit&) = default;
};

/// Recalls positions of a task: asks the worker to return the ones that it has not begun. Of a task
/// without analysis, recalls all positions from the first one in `positions` on.
struct AskBack {
    WorkerId worker;
    TaskId task;
    PositionSet positions;

    friend bool operator==(const AskBack&, const AskBack&) = default;
};

/// Reports how many positions of a task a worker has returned without answering them.
struct UnitsReturned {
    JobId job;
    std::uint64_t positions = 0;

    friend bool operator==(const UnitsReturned&, const UnitsReturned&) = default;
};

/// Cancels positions of a task that its original or its copy at another worker has answered.
struct CallOff {
    WorkerId worker;
    TaskId task;
    PositionSet positions;

    friend bool operator==(const CallOff&, const CallOff&) = default;
};

/// Worker process whose loss ended a task; empty if no loss ended it.
using LostWith = std::optional<InstanceId>;

/// Reports positions that were lost with a worker. The dispatcher queues analysed positions again.
/// Positions of a range leave the dispatcher, and the owner must have them analysed.
struct PositionsLost {
    JobId job;
    PositionSet positions;
    bool is_analysed = true;
    InstanceId process = 0;

    friend bool operator==(const PositionsLost&, const PositionsLost&) = default;
};

/// Tells the worker which blocks the scenarios in its buffer will need.
struct SendHint {
    WorkerId worker;
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.

    friend bool operator==(const SendHint&, const SendHint&) = default;
};

/// Asks to fail a scenario that was lost with `limits::scenario_losses_max` worker processes.
struct GiveUp {
    JobId job;
    std::uint64_t position = 0;

    friend bool operator==(const GiveUp&, const GiveUp&) = default;
};

using Action =
    std::variant<SendUnit, GiveUp, PositionsLost, AskBack, UnitsReturned, CallOff, SendHint>;
using Actions = std::vector<Action>;

} // namespace cd
