// The bounds of what a master remembers of those who were wrong, and of its threads.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

inline constexpr std::size_t alarms_kept_max = 20;
/// Processes, and not hosts: one that begins anew is another. More wrong ones no cluster survives.
inline constexpr std::size_t quarantined_kept_max = 4096;
/// Of workers that are gone, while a job runs: those that some result of it may be of come in
/// addition.
inline constexpr std::size_t worker_sessions_kept = 4096;
/// Of all jobs that run. For each that has a result: its hash, its place in a file, its author,
/// about 52 bytes of memory.
inline constexpr std::uint64_t scenarios_running_max = 1ull << 28;
/// Of all jobs that have ended: their places, 16 bytes each. Then the oldest job goes, but never
/// the latest.
inline constexpr std::uint64_t results_ended_kept_max = 1ull << 27;
inline constexpr std::size_t losses_again_that_count = 8; ///< Of a scenario, with one process.
inline constexpr std::size_t cuts_held_max = 1u << 15;    ///< Told of by one worker when it comes.
/// Of results that wait for the disk, or for their job. Beyond it each process has as many in hand
/// as ever.
inline constexpr std::uint64_t results_aside_bytes_max = 256u << 20;
inline constexpr unsigned blocking_threads = 4; ///< For the disk.

} // namespace cd::limits
