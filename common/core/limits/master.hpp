// Bounds of the master: connections, clients, jobs, the journal, matching and a job's end.
#pragma once

#include "common/core/limits/engine.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Connections.
inline constexpr std::size_t connections_max = 8192;
inline constexpr std::size_t greetings_max = 512;           ///< Connections before their greeting.
inline constexpr std::size_t worker_connections_max = 2048; ///< A holder or, without TLS, a host.
/// All workers' together; the rest of `connections_max` is for clients.
inline constexpr std::size_t all_worker_connections_max = 7168;
inline constexpr std::size_t http_connections_max = 64; ///< At once; each has one request.
inline constexpr std::chrono::hours client_idle_max{24};
inline constexpr std::chrono::seconds stop_grace{5}; ///< To finish what is under way at the end.
inline constexpr unsigned blocking_threads = 4;      ///< For reads and writes of files.

// Identity.
inline constexpr std::chrono::hours master_certificate_life{24 * 30};
inline constexpr std::chrono::hours certificate_life{24 * 7}; ///< Workers and clients, by default.
inline constexpr std::chrono::seconds certificate_life_min{2};
inline constexpr std::size_t tokens_max = 1024; ///< Valid tokens.
inline constexpr std::chrono::hours token_life_max{24 * 30};
inline constexpr std::chrono::seconds holder_check_period{10}; ///< Are connected holders refused?
inline constexpr std::size_t refused_bytes_max = 1u << 20;     ///< The file of refused holders.

// A client's share.
inline constexpr std::size_t client_connections_max = 64;
inline constexpr std::size_t client_jobs_max = 64;
inline constexpr std::uint64_t client_bytes_max = 256ull << 30; ///< Sent in one period.
inline constexpr std::chrono::hours client_bytes_period{24};
inline constexpr std::uint64_t client_queued_bytes_max = 64ull << 30; ///< Poses of its open jobs.
inline constexpr std::uint64_t client_scenarios_max = 1ull << 27;     ///< In its running jobs.
inline constexpr std::size_t client_uploads_max = 8;                  ///< Meshes, at once.
inline constexpr std::size_t watches_max = 64;                        ///< At once.
inline constexpr std::chrono::seconds retry_after{30}; ///< Advice to a client above its share.

// Messages of clients, and answers to them.
inline constexpr std::uint64_t poses_part_scenarios_max = 1u << 16;  ///< In one message.
inline constexpr std::uint64_t mesh_answer_bytes = 1u << 20;         ///< In one message.
inline constexpr std::uint64_t results_part_bytes_target = 4u << 20; ///< Uncompressed.
inline constexpr std::uint64_t results_scan_max = 1u << 20;    ///< Scenarios read for one answer.
inline constexpr std::size_t path_bytes_max = 4096;            ///< A file's name, for display.
inline constexpr std::chrono::seconds submission_idle_max{60}; ///< Between parts of an upload.
inline constexpr std::chrono::milliseconds watch_period{200};
inline constexpr std::chrono::seconds cancel_wait_max{10}; ///< Until the disk has a cancellation.

// Meshes and trees.
inline constexpr std::size_t meshes_max = 1u << 16;         ///< So that a status fits a message.
inline constexpr std::size_t mesh_uploads_max = 16;         ///< At once; each is a temporary file.
inline constexpr std::size_t trees_kept_max = 8;            ///< Of no running job.
inline constexpr std::uint64_t roots_chosen_max = 1u << 11; ///< Of a body at an automatic depth.
inline constexpr double block_bytes_wanted = 64u << 10;     ///< On the wire, at an automatic depth.
inline constexpr double wide_block_bytes_per_triangle = 10; ///< On the wire; an estimate.
inline constexpr double binary_block_bytes_per_triangle = 30; ///< On the wire; an estimate.

// Jobs.
inline constexpr std::size_t jobs_running_max = 256;
inline constexpr std::size_t jobs_ended_kept_max =
    1024;                                             ///< By default; then the oldest is dropped.
inline constexpr std::size_t jobs_kept_max = 100'000; ///< The highest setting of ended jobs kept.
inline constexpr std::chrono::seconds retention_check_period{30};
/// Scenarios in all running jobs. One with a result takes 52 bytes: its hash, place in a file,
/// author.
inline constexpr std::uint64_t scenarios_running_max = 1ull << 28;
/// Results of all ended jobs: 16 bytes each, for the place in a file. With more, the oldest job is
/// dropped, but never the latest.
inline constexpr std::uint64_t results_ended_kept_max = 1ull << 27;
inline constexpr std::size_t authors_kept_max = 1u << 18; ///< Results of an ended job with author.
inline constexpr std::size_t grid_bytes_max = 8u << 20;   ///< In memory and in the journal, each.
inline constexpr std::size_t ended_grid_bytes_max = 64u << 10; ///< In memory, of an ended job.
inline constexpr std::size_t ignored_ranges_max = 1u << 16;    ///< Each batch carries them.
inline constexpr std::uint32_t q_max = 1u << 16;
inline constexpr std::uint32_t v_kb_max = 16'384; ///< So that a batch fits a message.
inline constexpr std::uint64_t spool_run_scenarios =
    analysis_block_scenarios;                                    ///< Poses read together.
inline constexpr std::size_t result_buffer_bytes_max = 1u << 20; ///< Not yet written to a file.
inline constexpr std::size_t cuts_held_max = 1u << 15; ///< Trees that a joining worker may name.

// Losses.
inline constexpr std::uint32_t scenario_losses_max = 3;   ///< Then a scenario fails.
inline constexpr std::size_t losses_again_that_count = 8; ///< By one process; then it counts twice.
inline constexpr std::size_t alarms_kept_max = 20;
/// Worker processes in quarantine; a restarted worker is another process.
inline constexpr std::size_t quarantined_kept_max = 4096;
/// Sessions of departed workers, beside those that results of a running job refer to.
inline constexpr std::size_t worker_sessions_kept = 4096;

// Results on their way to the journal.
inline constexpr std::size_t results_in_hand_max = 8; ///< Messages of one worker under check.
/// Results that wait for the disk or for their job. With more, each process has at most
/// `results_in_hand_max` messages.
inline constexpr std::uint64_t results_aside_bytes_max = 256u << 20;
inline constexpr std::size_t journal_group_rows = 256; ///< With so many a commit begins at once.
inline constexpr std::chrono::milliseconds journal_group_period{5};  ///< Between two commits.
inline constexpr std::size_t journal_commit_rows_max = 8192;         ///< In one commit.
inline constexpr std::uint64_t journal_commit_bytes_max = 64u << 20; ///< Records in one commit.
inline constexpr std::uint64_t journal_queue_bytes_max = 256u
                                                         << 20; ///< Then workers are read later.
inline constexpr std::chrono::milliseconds journal_retry_period{500}; ///< On a full disk.

// Workers.
inline constexpr std::chrono::hours peer_lost_after_max{24};
inline constexpr std::chrono::milliseconds peer_check_period{500};
inline constexpr std::chrono::minutes worker_forgotten_after{10}; ///< After its last message.
inline constexpr std::size_t lost_workers_kept_max = 1024;        ///< Then the oldest is dropped.
inline constexpr double scenario_seconds_shown = 10; ///< Status names scenarios that take longer.
inline constexpr std::size_t long_scenarios_shown = 16; ///< Of one job.

// Delivery of blocks.
inline constexpr std::size_t subtrees_queue_bytes_max = 16u << 20; ///< Towards one worker.
inline constexpr std::size_t peer_unreachable_by_max = 2; ///< Then it is no longer a source.
inline constexpr std::size_t sources_looked_at_max = 64;  ///< For one wanted block.
inline constexpr std::chrono::seconds peer_fetch_max{60}; ///< One fetch from a peer.
inline constexpr std::chrono::seconds peer_wait_max{10};  ///< For a block that only peers hold.

// Dispatch.
inline constexpr std::uint64_t unsent_scenarios_max = 4096; ///< Analysed, beyond workers' buffers.
inline constexpr std::uint64_t unsent_by_time_max = 1u << 18; ///< Analysed, if matched by time.
inline constexpr std::uint64_t open_analyses_bytes_max = 512u << 20; ///< Unanswered, in memory.
/// With more workers, an event looks at a part of them, so that its cost stays bounded.
inline constexpr std::size_t workers_few = 64;
inline constexpr double look_seconds_each = 2e-6;

// Matching by time: assumptions until something is measured, and the size of batches.
inline constexpr double link_bytes_per_second_start = 125e6;  ///< 1 Gb/s.
inline constexpr double block_seconds = 20e-6;                ///< To ask for a block and open it.
inline constexpr std::uint64_t block_bytes_per_triangle = 16; ///< On the wire.
inline constexpr std::uint64_t scenario_ns_unknown = 1'000'000;
inline constexpr double batch_seconds_start = 0.1;
inline constexpr double batch_seconds_min = 0.001;
inline constexpr double batch_seconds_max = 1;
inline constexpr double batch_overhead_max = 0.02; ///< Above this share batches grow.
inline constexpr std::size_t batches_at_worker = 2;
inline constexpr double scenario_seconds_long = 0.05; ///< Longer than any round trip matters.
inline constexpr std::size_t moves_tried_max = 64;    ///< At once, towards a worker that runs dry.

// The end of a job: no work waits, and some workers are idle.
inline constexpr double copies_share_max = 0.05;     ///< Of a job's work may be done twice.
inline constexpr double copy_gain_min = 1.5;         ///< A copy must end so many times sooner.
inline constexpr double end_gain_seconds_min = 0.02; ///< Less is not worth the messages.
inline constexpr double recall_answer_seconds = 0.5; ///< Then a recall counts as unanswered.
inline constexpr std::uint32_t scenario_recalls_max = 3;
inline constexpr std::chrono::milliseconds end_check_period{100}; ///< Between straggler searches.
inline constexpr std::size_t late_looked_at_min = 64;             ///< Stragglers examined at least.
inline constexpr std::size_t late_looked_at_part = 16; ///< Or one in so many workers, if more.
inline constexpr std::size_t helpers_tried_max = 4;    ///< For each straggler.

} // namespace cd::limits
