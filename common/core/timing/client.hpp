// Periods, timeouts and lifetimes of clients.
#pragma once

#include <chrono>

namespace cd::timing {

// A run on one machine.
inline constexpr std::chrono::milliseconds progress_period{100};
/// A step that takes longer is named in a line on stderr.
inline constexpr std::chrono::milliseconds slow_note_after{500};

// Mesh files.
/// Processor time that the child process which reads a mesh file with assimp gets for a small file.
inline constexpr std::chrono::seconds reader_seconds_min{20};

// Caches and results folders.
/// Period in which a run flushes its results; a killed run loses later ones.
inline constexpr std::chrono::seconds record_flush_period{5};

// A master.
/// cdctl waits this long for an answer that costs the master no work.
inline constexpr std::chrono::seconds answer_timeout{30};
/// cdctl waits this long for the master to store a mesh or to accept a job.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600};
/// Without a change of its job's status for this long, `cdctl watch` asks for the cluster's status.
inline constexpr std::chrono::seconds watch_look_period{1};
/// While its job's status changes, `cdctl watch` asks for the cluster's status this often.
inline constexpr std::chrono::seconds watch_look_period_going_on{10};
/// After Ctrl-C, cdctl closes the connection if a call does not end within this time.
inline constexpr std::chrono::milliseconds stop_patience{1000};
/// cdctl retries a lost connection for this long.
inline constexpr std::chrono::seconds come_back_max{60};
inline constexpr std::chrono::milliseconds come_back_period{300}; ///< Pause between two attempts.

// The cluster that `cdctl demo` starts on this host.
inline constexpr std::chrono::seconds local_start_max{
    30}; ///< Time for master and workers to start.
/// Pause between two looks at the processes.
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::timing
