// The bounds of what peers may ask of the master, and tell it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

/// In one message: identities take a few bytes on the wire, and hundreds in memory.
inline constexpr std::uint64_t poses_part_scenarios_max = 1u << 16;
inline constexpr std::uint64_t poses_answer_scenarios = 1u << 12; ///< In one answer to a client.
inline constexpr std::uint64_t mesh_answer_bytes = 1u << 20;      ///< Of a mesh, in one answer.
inline constexpr std::size_t label_bytes_max = 256;               ///< Of a scenario's id.
inline constexpr std::size_t path_bytes_max = 4096;               ///< Of a file's name, for people.
inline constexpr std::size_t grid_bytes_max = 8u << 20;        ///< In memory and the journal, each.
inline constexpr std::size_t ended_grid_bytes_max = 64u << 10; ///< In memory, when it has ended.
inline constexpr std::uint64_t client_queued_bytes_max = 64ull << 30; ///< Of jobs not yet done.
inline constexpr std::uint64_t client_scenarios_max = 1ull << 27;     ///< Of its jobs that run.
inline constexpr std::size_t client_uploads_max = 8;                  ///< Meshes, begun.
/// Of the workers of one holder, or, without TLS, host.
inline constexpr std::size_t worker_connections_max = 2048;
/// Of all: then only other clients find a place.
inline constexpr std::size_t all_worker_connections_max = 7168;
inline constexpr std::chrono::seconds submission_idle_max{60}; ///< Of a begun mesh, or poses.
inline constexpr std::chrono::seconds retry_after{30};         ///< Told who asks too much.
inline constexpr std::size_t meshes_max = 1u << 16;            ///< So that a status fits a message.
inline constexpr std::chrono::seconds holder_check_period{10}; ///< Of those who are connected.
inline constexpr std::size_t refused_bytes_max = 1u << 20;     ///< The list of refused holders.

/// Told in one message of results: sums of it stay numbers.
inline constexpr double compute_seconds_max = 1e7;

} // namespace cd::limits
