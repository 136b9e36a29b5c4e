// Bounds of a worker's process.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Work.
inline constexpr std::size_t jobs_per_thread_max = 4;  ///< Begun or queued scenarios and descents.
inline constexpr std::size_t walk_scenarios_max = 256; ///< Scenarios that one descent takes.
/// Number of scenarios that wait for subtrees or threads. With more, the worker begins no further
/// descent of the upper trees.
inline constexpr std::size_t walked_waiting_max = 4096;
/// Number of descents, of about a millisecond each, after which a worker joins the blocks of a tree
/// of which it holds all, and after which it adds support points.
inline constexpr std::uint32_t join_descents_min = 30;
inline constexpr std::uint32_t points_descents_min = 1500;
/// A joined tree may be dropped for another one after this many descents that did not use it.
inline constexpr std::uint64_t joined_unused_descents = 3000;
/// Number of searches of joined trees that a job keeps for further descents.
inline constexpr std::size_t joined_searches_max = 64;
/// Estimated memory of a binary subtree per triangle.
inline constexpr std::uint64_t binary_bytes_per_triangle = 128;

// Results.
/// A task's results are sent once their uncompressed size reaches this.
inline constexpr std::size_t results_flush_bytes = 1u << 20;
// Bounds on results that the master has not acknowledged. At either bound the worker begins no
// further scenario.
inline constexpr std::uint64_t results_unkept_bytes_max = 64u << 20;
inline constexpr std::size_t results_unkept_messages_max = 1u << 14;

// Blocks.
/// Number of trees without a job whose blocks stay cached. A Holding names all of them, so their
/// number is at most `cuts_held_max`.
inline constexpr std::size_t parked_trees_max = 1u << 13;
/// Number of hints whose blocks are not fetched yet; with more, the worker drops the oldest.
inline constexpr std::size_t hints_max = 1u << 16;
/// Unpacked size of the blocks that are being requested ahead of need.
inline constexpr std::uint64_t hinted_bytes_max = 2u << 20;

// Peers.
inline constexpr std::size_t peer_connections_max = 64; ///< Connections from other workers.
/// Idle connections to other workers that are kept for reuse.
inline constexpr std::size_t peer_channels_kept_max = 16;

// Connecting to the master.
/// A connection counts as short if it lasts less than this many times the tolerated silence.
inline constexpr int short_connection_silences = 4;

} // namespace cd::limits
