// What both ends of every connection say.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "proto/messages/traffic.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// Both sides of a connection speak the same version.
inline constexpr std::uint16_t protocol_version = 9;

enum class Role : std::uint8_t {
    Worker = 1,
    Client = 2,
    Peer = 3,
    Joiner = 4, ///< Wants a certificate, and nothing else.
};

/// The first message on a connection. If the version differs, nothing else of it is read.
struct Hello {
    std::uint16_t version = protocol_version;
    Role role = Role::Client;
    std::string name;              ///< For people: host and process, or what --name said.
    std::string build;             ///< Version of the program.
    std::uint32_t threads = 0;     ///< Of a worker.
    std::uint64_t cache_bytes = 0; ///< Of a worker: the limit of its subtree cache.
    std::uint16_t peer_port = 0;   ///< Of a worker: where others fetch blocks from it; 0: nowhere.
    double weight = 1;             ///< Of a worker: multiplies its speed, where that counts.
    std::uint64_t instance = 0;    ///< Of a worker: drawn when its process started, kept since.
    // Of a worker that would go on with a session whose connection broke: what its Welcome said.
    std::uint64_t session = 0; ///< The WorkerId; 0: it has none to go on with.
    std::uint64_t epoch = 0;
    std::string user = {}; ///< Client: user@host, the owner of its jobs without TLS.
};

/// A secret of the master and one worker, by which the worker knows the master's tickets.
using PeerKey = Sha256;

/// The master's answer to a Hello that it accepts.
struct Welcome {
    std::uint16_t version = protocol_version;
    std::uint64_t id = 0; ///< A WorkerId, or the client's number.
    std::string build;
    PeerKey peer_key; ///< Of a worker; else zeros.
    Sha256 cluster; ///< Names the master's state: numbers of jobs mean the same as long as it does.
    std::uint64_t epoch = 0; ///< Names the master's process.
    bool is_resumed = false; ///< The worker's session goes on: what both hold of it still counts.
    std::uint32_t heartbeat_ms = 0;  ///< The period of heartbeats, which a worker keeps to, too;
    std::uint32_t lost_after_ms = 0; ///< after so long a silence its work goes to others.
    std::string owner = {};          ///< Client: the owner of its jobs.
};

/// The other side cannot or will not. To a client it answers the request before it.
struct Failure {
    ErrorCode code = ErrorCode::Refused;
    std::string detail;
};

/// A scenario that a thread is busy with.
struct RunningScenario {
    JobId job;
    std::uint64_t scenario = 0;
    double seconds = 0; ///< Since it was begun.

    friend bool operator==(const RunningScenario&, const RunningScenario&) = default;
};

struct Heartbeat {
    std::uint64_t sequence = 0;
    std::uint64_t cached_bytes = 0;              ///< Of a worker.
    std::uint64_t waiting = 0;                   ///< Scenarios at the worker not yet answered.
    CacheTraffic traffic;                        ///< Of a worker.
    std::optional<RunningScenario> longest = {}; ///< Of those that run at the worker.
};

} // namespace cd
