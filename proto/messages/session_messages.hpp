// Messages of every connection: greeting, failure and heartbeat.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/host/boot_id.hpp"
#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "proto/messages/traffic.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// Both ends of a connection must use one version.
inline constexpr std::uint16_t protocol_version = 23;

enum class Role : std::uint8_t {
    Worker = 1,
    Client = 2,
    Peer = 3,
    Joiner = 4, ///< Only requests a certificate.
};

/// The session that a worker wants to continue.
struct SessionToResume {
    std::uint64_t id = 0;    ///< Its WorkerId; 0: none.
    std::uint64_t epoch = 0; ///< Epoch in its Welcome.
};

/// The first message on a connection. In each version of the protocol it begins with version, role
/// and name. If the version differs, the other members are not read.
struct Hello {
    std::uint16_t version = protocol_version;
    Role role = Role::Client;
    std::string name;              ///< Display name: host and process, or --name.
    std::string build;             ///< Program version.
    std::uint32_t threads = 0;     ///< Worker: number of threads.
    std::uint64_t cache_bytes = 0; ///< Worker: limit of its subtree cache.
    std::uint16_t peer_port = 0;   ///< Worker: port that serves blocks; 0: none.
    double weight = 1;             ///< Worker: speed factor in the master's time estimates.
    std::uint64_t instance = 0;    ///< Worker: random id of its process.
    SessionToResume resumed = {};  ///< Worker: the session to resume, if any.
    std::string user = {};         ///< Client: user@host, the owner of its jobs without TLS.
    std::uint64_t boot_id = cd::boot_id(); ///< Of the sender's host.
};

/// A secret shared by the master and one worker; it authenticates the master's tickets.
using PeerKey = Sha256;

/// The master's answer to a Hello that it accepts.
struct Welcome {
    std::uint16_t version = protocol_version;
    std::uint64_t id = 0; ///< The WorkerId, or the number of the client.
    std::string build;
    PeerKey peer_key;        ///< Workers only; otherwise zeros.
    Sha256 cluster;          ///< Identifies the master's state; JobIds are valid within one.
    std::uint64_t epoch = 0; ///< Identifies the incarnation of the master.
    bool is_resumed = false; ///< True: the worker's session continues, with its TreeIds and tasks.
    std::uint32_t heartbeat_ms = 0;  ///< Heartbeat period of both ends, ms.
    std::uint32_t lost_after_ms = 0; ///< Silence after which a worker's tasks are reassigned, ms.
    std::string owner = {};          ///< Client: the owner of its jobs.
    std::uint64_t boot_id = cd::boot_id(); ///< Of the sender's host.
};

/// The sender cannot or will not proceed. Sent to a client, a Failure answers the last request.
struct Failure {
    ErrorCode code = ErrorCode::Refused;
    std::string detail;
};

/// A scenario that a thread is computing.
struct RunningScenario {
    JobId job;
    std::uint64_t scenario = 0;
    double seconds = 0; ///< Time since the scenario's start.

    friend bool operator==(const RunningScenario&, const RunningScenario&) = default;
};

struct Heartbeat {
    std::uint64_t sequence = 0;                  ///< Number of the sender's heartbeat.
    std::uint64_t cached_bytes = 0;              ///< Worker: size of its subtree cache.
    std::uint64_t waiting = 0;                   ///< Worker: its unanswered scenarios.
    CacheTraffic traffic;                        ///< Worker: its traffic; see CacheTraffic.
    std::optional<RunningScenario> longest = {}; ///< Worker: its longest-running scenario.
};

} // namespace cd
