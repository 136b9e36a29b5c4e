// Actions that the dispatcher asks its owner to perform.
#pragma once

#include "common/core/id.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/tree/cut.hpp"
#include "master/base/instance_id.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace cd {

/// Asks to send these scenarios to this worker as one task.
struct SendBatch {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::vector<std::uint64_t> scenarios;
    bool is_copy = false; ///< Speculative copy: another worker has the scenarios too.

    friend bool operator==(const SendBatch&, const SendBatch&) = default;
};

/// Asks to send these positions in the job's hand-out order to this worker as one task, without
/// analysis: the worker finds the colliding roots.
struct SendRange {
    WorkerId worker;
    TaskId task;
    JobId job;
    PlaceRange places;
    TaskId copy_of = {}; ///< Another worker's task that has these positions; 0 if not a copy.

    friend bool operator==(const SendRange&, const SendRange&) = default;
};

/// Recall: asks the worker to return the part of the task that it has not begun.
struct AskBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Wanted scenarios of a batch, ascending.
    std::uint64_t places = 0;             ///< Number of a range's first positions to keep.

    friend bool operator==(const AskBack&, const AskBack&) = default;
};

/// Reports that a worker has returned part of a task. The owner must queue the positions again; the
/// dispatcher has queued the scenarios.
struct GivenBack {
    TaskId task;
    JobId job;
    std::uint64_t scenarios = 0; ///< Number of scenarios returned of a batch.
    PlaceRange places;           ///< Positions returned of a range, all unanswered.

    friend bool operator==(const GivenBack&, const GivenBack&) = default;
};

/// Cancels the scenario at this worker: another one has answered it.
struct CallOff {
    WorkerId worker;
    TaskId task;
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const CallOff&, const CallOff&) = default;
};

/// Worker process whose loss ended a task; empty if no loss ended it.
using LostWith = std::optional<InstanceId>;

/// Reports that the task of a range has ended. The owner must hand its unanswered positions out
/// again, and analyse them first if they were lost.
struct RangeEnded {
    TaskId task;
    JobId job;
    PlaceRange places;
    LostWith lost_with;

    friend bool operator==(const RangeEnded&, const RangeEnded&) = default;
};

/// Tells the worker which blocks the scenarios in its buffer will need.
struct SendHint {
    WorkerId worker;
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.

    friend bool operator==(const SendHint&, const SendHint&) = default;
};

/// Reports scenarios of a batch that were lost with a worker. Precedes any action that resends one
/// of them.
struct ScenariosLost {
    JobId job;
    std::vector<std::uint64_t> scenarios;
    InstanceId process = 0;

    friend bool operator==(const ScenariosLost&, const ScenariosLost&) = default;
};

/// Asks to fail a scenario that was lost with `limits::scenario_losses_max` worker processes.
struct GiveUp {
    JobId job;
    std::uint64_t scenario = 0;

    friend bool operator==(const GiveUp&, const GiveUp&) = default;
};

using Action = std::variant<SendBatch,
                            GiveUp,
                            SendRange,
                            RangeEnded,
                            ScenariosLost,
                            AskBack,
                            GivenBack,
                            CallOff,
                            SendHint>;
using Actions = std::vector<Action>;

} // namespace cd
