// Bounds of messages, frames, connections and identities: what proto/ enforces, and what both ends
// of a connection must agree on.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Messages. The channel checks a type's cap while frames arrive, before it keeps more
// (PROTOCOL.md).
inline constexpr std::uint64_t message_control_bytes_max =
    1u << 20; ///< Types that the constants below do not name.
/// A message with a list of distribution roots of one tree.
inline constexpr std::uint64_t message_roots_bytes_max = 8u << 20;
/// A message with a part of a mesh or of a submission.
inline constexpr std::uint64_t message_part_bytes_max = 16u << 20;
inline constexpr std::uint64_t message_data_bytes_max = 64u << 20;       ///< A unit of work.
inline constexpr std::uint64_t message_results_bytes_max = 257u << 20;   ///< Holds any one record.
inline constexpr std::uint64_t message_subtrees_bytes_max = 1025u << 20; ///< Holds any one block.
inline constexpr std::uint64_t greeting_bytes_max = 4u << 10;            ///< The first message.
inline constexpr std::uint64_t join_bytes_max = 64u << 10; ///< A join holds a PEM request.
/// Any message of a client with role `metrics`.
inline constexpr std::uint64_t observer_bytes_max = 4u << 10;
inline constexpr std::size_t hello_text_bytes_max = 256; ///< A name or another text in a greeting.

// Messages that a peer may have begun and not completed at the same time.
/// For a peer that has greeted, before its role is checked.
inline constexpr std::size_t streams_max = 4;
inline constexpr std::size_t streams_small_max = 1;    ///< For peers that send only small messages.
inline constexpr std::size_t streams_of_lanes_max = 2; ///< For all other peers: one in each lane.

// Frames.
inline constexpr std::size_t frame_payload_bytes_max = 1u << 20;
/// Every frame of a message but the last carries at least this, so that a message has few frames.
inline constexpr std::size_t frame_with_more_bytes_min = 256u << 10;
/// A sender waits while more bytes than this are queued.
inline constexpr std::size_t write_queue_bytes_max = 64u << 20;

// Contents that proto/ checks.
/// Length of a range that is sent as one task.
inline constexpr std::uint64_t range_scenarios_max = 1u << 14;
/// Poses in one answer to a client.
inline constexpr std::uint64_t poses_answer_scenarios = 1u << 12;
inline constexpr std::size_t strategy_name_bytes_max = 32;
/// Workers that the master names as sources of one fetch.
inline constexpr std::size_t peer_sources_max = 3;
inline constexpr std::uint32_t worker_threads_max = 4096;
inline constexpr double worker_weight_max = 1000; ///< Factor that a worker states for its speed.

// TLS and certificates.
inline constexpr std::size_t certificate_bytes_max = 16u << 10; ///< One PEM text.
inline constexpr std::size_t certified_name_bytes_max = 64;     ///< Also RFC 5280's bound.
inline constexpr std::uint32_t token_uses_max = 100'000;        ///< Joins with one token.
/// Bytes sent under one key; after that, the two ends agree on a new key.
inline constexpr std::uint64_t tls_key_bytes_max = 64ull << 30;
/// Bytes read and dropped after a connection is refused.
inline constexpr std::size_t refused_tls_bytes_max = 1u << 20;
/// Number of the newest tickets that a worker remembers; it refuses older tickets.
inline constexpr std::size_t peer_tickets_remembered = 1u << 16;

// Log lines about refused connections.
/// Log lines about one host in a period; further refusals are only counted.
inline constexpr std::size_t refusal_lines_max = 8;
/// Hosts that are counted apart; all further hosts are counted together.
inline constexpr std::size_t refusal_hosts_max = 1024;

// Silence and stalls.
inline constexpr unsigned heartbeats_missed_max = 3; ///< After so many, a worker gets no new work.
// TCP keepalive: a connection ends within half a minute after its other host is gone, also where
// neither end sends anything, as while a client waits until the master has stored a large mesh.
inline constexpr int keepalive_idle_seconds = 15;
inline constexpr int keepalive_period_seconds = 5;
inline constexpr int keepalive_probes = 3;

// HTTP.
inline constexpr std::uint32_t http_request_bytes_max = 16u << 10;

// Workers that fetch blocks from each other.
inline constexpr std::size_t peer_uploads_max = 2; ///< Workers that one worker serves at once.

} // namespace cd::limits
