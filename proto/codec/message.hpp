// The messages between the programs, one struct each. PROTOCOL.md describes their order.
#pragma once

#include "proto/messages/client_messages.hpp"
#include "proto/messages/identity_messages.hpp"
#include "proto/messages/job_changes.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <variant>

namespace cd {

/// All messages in the order of their numbers on the wire, which start at 1 and never change.
using Message = std::variant<Hello,
                             Welcome,
                             Failure,
                             Heartbeat,
                             AddTree,
                             RemoveTree,
                             Subtrees,
                             WorkUnit,
                             Drain,
                             Terminate,
                             WantSubtrees,
                             Results,
                             EndOfTask,
                             Evicted,
                             MeshesQuery,
                             MeshesMissing,
                             MeshPart,
                             MeshStored,
                             Submit,
                             PosesPart,
                             PosesEnd,
                             Accepted,
                             Watch,
                             JobStatus,
                             StatusQuery,
                             ClusterStatus,
                             ResultsQuery,
                             ResultsPart,
                             Cancel,
                             FetchFromPeers,
                             Held,
                             FetchFailed,
                             PeerFetch,
                             PeerFetched,
                             Explain,
                             Explained,
                             AddJob,
                             RemoveJob,
                             ResultsKept,
                             Holding,
                             Join,
                             Renew,
                             Certified,
                             TokenCreate,
                             TokenCreated,
                             Inventory,
                             DropScenario,
                             Recall,
                             Recalled,
                             Hint,
                             ContactMapQuery,
                             ContactMapAnswer,
                             JobQuery,
                             JobDescription,
                             MeshQuery,
                             MeshBytes,
                             PosesQuery,
                             JobPoses,
                             Remove,
                             RemoveMesh,
                             Removed,
                             DrainWorkers,
                             Draining,
                             SetPriority>;

} // namespace cd
