// The bounds of what a master remembers of those who were wrong, and of its threads.
#pragma once

#include <cstddef>

namespace cd::limits {

inline constexpr std::size_t alarms_kept_max = 20;
/// Processes, and not hosts: one that begins anew is another. More wrong ones no cluster survives.
inline constexpr std::size_t quarantined_kept_max = 4096;
/// Of workers that are gone, while a job runs: those that some result of it may be of come in
/// addition.
inline constexpr std::size_t worker_sessions_kept = 4096;
inline constexpr unsigned blocking_threads = 4; ///< For the disk.

} // namespace cd::limits
