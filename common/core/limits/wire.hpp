// Bounds of messages, frames, connections and identities, which proto/ enforces or on which both
// ends of a connection must agree.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Messages: bounds of their payload by type. The channel checks the bound while frames arrive
// (PROTOCOL.md).
inline constexpr std::uint64_t message_control_bytes_max =
    1u << 20; ///< Most types: those without a bound of their own.
/// A message with a list of distribution roots of one tree.
inline constexpr std::uint64_t message_roots_bytes_max = 8u << 20;
/// A message with a part of a mesh or of a submission.
inline constexpr std::uint64_t message_part_bytes_max = 16u << 20;
inline constexpr std::uint64_t message_data_bytes_max = 64u << 20;       ///< Work or a job's data.
inline constexpr std::uint64_t message_results_bytes_max = 257u << 20;   ///< Holds any one record.
inline constexpr std::uint64_t message_subtrees_bytes_max = 1025u << 20; ///< Holds any one block.
inline constexpr std::uint64_t greeting_bytes_max = 4u << 10;            ///< The first message.
inline constexpr std::uint64_t join_bytes_max = 64u << 10; ///< A join holds a PEM request.
/// Any message of a client whose certificate has the role `metrics`.
inline constexpr std::uint64_t observer_bytes_max = 4u << 10;
inline constexpr std::size_t hello_text_bytes_max = 256; ///< A name or another text in a greeting.

// Messages of a peer that may be incomplete at the same time.
/// For a peer that has greeted and whose role is not checked yet.
inline constexpr std::size_t streams_max = 4;
inline constexpr std::size_t streams_small_max = 1;    ///< For peers that send only small messages.
inline constexpr std::size_t streams_of_lanes_max = 2; ///< For all other peers: one in each lane.

// Frames.
inline constexpr std::size_t frame_payload_bytes_max = 1u << 20;
/// Each frame of a message except the last has at least this payload, so that frames are few.
inline constexpr std::size_t frame_with_more_bytes_min = 256u << 10;
/// A sender splits a message into frames of at most this payload. A link of 9 kB/s delivers such a
/// frame within `timing::read_stall_max`.
inline constexpr std::size_t frame_sent_bytes_max = frame_with_more_bytes_min;
/// A sender waits while more bytes than this are queued.
inline constexpr std::size_t write_queue_bytes_max = 64u << 20;

// Contents that proto/ checks.
/// Number of scenarios in a range that is sent as one task.
inline constexpr std::uint64_t range_scenarios_max = 1u << 14;
/// Scenarios whose poses one answer to a client holds.
inline constexpr std::uint64_t poses_answer_scenarios = 1u << 12;
inline constexpr std::size_t strategy_name_bytes_max = 32;
/// Workers that the master names as sources of one fetch of blocks.
inline constexpr std::size_t peer_sources_max = 3;
inline constexpr std::uint32_t worker_threads_max = 4096;
inline constexpr double worker_weight_max = 1000; ///< Speed factor that a worker states.

// TLS and certificates.
inline constexpr std::size_t certificate_bytes_max = 16u << 10; ///< One PEM text.
inline constexpr std::size_t certified_name_bytes_max = 64;     ///< Also RFC 5280's bound.
inline constexpr std::uint32_t token_uses_max = 100'000;        ///< Joins with one token.
/// Bytes sent under one key; then the sender changes its key.
inline constexpr std::uint64_t tls_key_bytes_max = 64ull << 30;
/// Bytes read and dropped before a refused connection closes.
inline constexpr std::size_t refused_tls_bytes_max = 1u << 20;
/// Number of the newest tickets that a worker remembers; it refuses older tickets.
inline constexpr std::size_t peer_tickets_remembered = 1u << 16;

// Log lines about refused connections.
/// Log lines about one host in `timing::refusal_log_period`; further refusals are only counted.
inline constexpr std::size_t refusal_lines_max = 8;
/// Hosts whose refusals are counted separately; all further hosts are counted together.
inline constexpr std::size_t refusal_hosts_max = 1024;

// Silence and stalls.
inline constexpr unsigned heartbeats_missed_max = 3; ///< After so many, a peer counts as silent.
// TCP keepalive: a connection ends within half a minute after its peer's host is gone, even if
// neither end sends data, for example while the master stores a large mesh for a client.
inline constexpr int keepalive_idle_seconds = 15;
inline constexpr int keepalive_period_seconds = 5;
inline constexpr int keepalive_probes = 3;

// HTTP.
inline constexpr std::uint32_t http_request_bytes_max = 16u << 10;

// Workers that fetch blocks from each other.
inline constexpr std::size_t peer_uploads_max = 2; ///< Workers that one worker serves at once.

} // namespace cd::limits
