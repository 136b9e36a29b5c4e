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
    bool is_copy = false; ///< Speculative copy: another worker has them too.

    friend bool operator==(const SendBatch&, const SendBatch&) = default;
};

/// Asks to send these positions of the job's order to this worker as one task. The worker finds the
/// colliding roots itself.
struct SendRange {
    WorkerId worker;
    TaskId task;
    JobId job;
    PlaceRange places;
    TaskId copy_of = {}; ///< Task of another worker with these positions; none if not a copy.

    friend bool operator==(const SendRange&, const SendRange&) = default;
};

/// Asks the worker to return what it has not begun of the task: of a batch these scenarios, of a
/// range all but its first `places` positions.
struct AskBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Ascending.
    std::uint64_t places = 0;

    friend bool operator==(const AskBack&, const AskBack&) = default;
};

/// A worker has returned part of a task. The unanswered positions must be queued again.
struct GivenBack {
    TaskId task;
    JobId job;
    std::uint64_t scenarios = 0; ///< Number returned of a batch.
    PlaceRange places;           ///< Positions returned of a range.

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

/// Process whose loss ended a task; empty if the unanswered rest was returned.
using LostWith = std::optional<InstanceId>;

/// The task of a range has ended. Its unanswered positions must be repeated, and are analysed first
/// if they were lost.
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

/// Fails a scenario that was lost with `limits::scenario_losses_max` worker processes.
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
