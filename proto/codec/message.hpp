// The messages between the programs, one struct each. PROTOCOL.md describes their order.
#pragma once

#include "proto/messages/client_messages.hpp"
#include "proto/messages/identity_messages.hpp"
#include "proto/messages/party.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <string_view>
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
                             Draining>;

/// A message's type number on the wire: its index in `Message`, from 1.
[[nodiscard]] std::uint16_t message_type(const Message& message);
/// Returns the name of a message type for logs; "unknown" for an unknown number.
[[nodiscard]] std::string_view message_name(std::uint16_t type);

/// The largest payload of a type, bytes (limits/wire.hpp): small for control messages, larger for
/// data. 0 for an unknown type.
[[nodiscard]] std::uint64_t payload_bytes_max(std::uint16_t type);

/// Whether a type travels in the data lane. Each lane keeps the order of its messages; control
/// overtakes data.
[[nodiscard]] bool travels_as_data(std::uint16_t type);
/// The largest payload, in bytes, that this party may send in this type of message; 0: none, the
/// type is forbidden.
[[nodiscard]] std::uint64_t payload_bytes_max_from(Party party, std::uint16_t type);

} // namespace cd
