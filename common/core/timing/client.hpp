// Periods, timeouts and lifetimes of clients.
#pragma once

#include <chrono>

namespace cd::timing {

// A run on one machine.
inline constexpr std::chrono::milliseconds progress_period{100};
/// After this time, cdctl names the running step in a line on stderr.
inline constexpr std::chrono::milliseconds slow_note_after{500};

// Mesh files.
/// Processor time for the child process that reads a mesh file with assimp; large files get more.
inline constexpr std::chrono::seconds reader_seconds_min{20};

// Reports.
/// A scenario is run again for its picture for at most this time.
inline constexpr std::chrono::seconds report_run_max{30};

// Caches and results folders.
/// Period in which a run flushes its results; a killed run loses the results since the last flush.
inline constexpr std::chrono::seconds record_flush_period{5};

// A master.
/// cdctl waits this long for an answer that costs the master no work.
inline constexpr std::chrono::seconds answer_timeout{30};
/// While someone types a command line, cdctl asks the master for job ids for at most this time.
inline constexpr std::chrono::milliseconds completion_max{300};
/// `cdctl doctor` waits this long for each step of reading the master's HTTP port.
inline constexpr std::chrono::seconds doctor_http_max{2};
/// `cdctl doctor` warns of a certificate that ends sooner.
inline constexpr std::chrono::hours doctor_certificate_left_min{24};
/// `cdctl doctor` warns of clocks that differ by more. `clock_difference_max` breaks connections.
inline constexpr std::chrono::seconds doctor_clock_difference_max{30};
/// cdctl waits this long for the master to store a mesh or to accept a job.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600};
/// `cdctl watch` asks for the cluster's status once the job's status is unchanged for this long.
inline constexpr std::chrono::seconds watch_look_period{1};
/// While the job's status changes, `cdctl watch` asks for the cluster's status this often.
inline constexpr std::chrono::seconds watch_look_period_going_on{10};
/// After Ctrl-C, cdctl closes the connection if a call does not end within this time.
inline constexpr std::chrono::milliseconds stop_patience{1000};
/// cdctl tries for this long to restore a lost connection.
inline constexpr std::chrono::seconds come_back_max{60};
inline constexpr std::chrono::milliseconds come_back_period{300}; ///< Pause between two attempts.

// The cluster that `cdctl demo` starts on this host.
inline constexpr std::chrono::seconds local_start_max{
    30}; ///< Time for master and workers to start.
/// Pause between two checks of whether the processes run.
inline constexpr std::chrono::milliseconds process_poll_period{10};

} // namespace cd::timing
