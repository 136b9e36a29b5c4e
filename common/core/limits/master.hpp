// Bounds of the master: connections, clients, jobs, the journal, matching and the end of a job.
#pragma once

#include "common/core/limits/engine.hpp"

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Connections.
inline constexpr std::size_t connections_max = 8192;
inline constexpr std::size_t greetings_max = 512; ///< Connections that have not been admitted yet.
/// Worker connections of one certificate holder or, without TLS, of one host.
inline constexpr std::size_t worker_connections_max = 2048;
/// Connections of all workers; the rest of `connections_max` is for clients.
inline constexpr std::size_t all_worker_connections_max = 7168;
inline constexpr unsigned blocking_threads = 4; ///< Threads that read and write files.

// Identity.
inline constexpr std::size_t tokens_max = 1024; ///< Tokens that are valid at the same time.
inline constexpr std::size_t refused_bytes_max = 1u << 20; ///< Size of the list of refused holders.

// A client's share.
inline constexpr std::size_t client_connections_max = 64;
inline constexpr std::size_t client_jobs_max = 64;
/// Bytes of meshes, poses and grids that a client sends in `timing::client_bytes_period`.
inline constexpr std::uint64_t client_bytes_max = 256ull << 30;
inline constexpr std::uint64_t client_queued_bytes_max = 64ull << 30; ///< Poses of unfinished jobs.
/// Unfinished scenarios in a client's jobs.
inline constexpr std::uint64_t client_scenarios_max = 1ull << 27;
inline constexpr std::size_t client_uploads_max = 8; ///< Simultaneous mesh uploads.
inline constexpr std::size_t watches_max = 64;       ///< Jobs that one connection watches.

// Messages of clients, and answers to them.
inline constexpr std::uint64_t mesh_answer_bytes = 1u << 20; ///< Mesh bytes in an answer.
/// Uncompressed size of the records in one answer. A single larger record is sent alone.
inline constexpr std::uint64_t results_part_bytes_target = 4u << 20;
inline constexpr std::uint64_t results_scan_max = 1u << 20; ///< Scenarios read for one answer.
/// Poses of a sample in one answer. Each may be in another window of poses, which is read whole.
inline constexpr std::uint64_t sampled_poses_answer_max = 512;
inline constexpr std::size_t path_bytes_max = 4096; ///< Length of a file's name, for display.

// Meshes and trees.
inline constexpr std::size_t meshes_max = 1u << 16; ///< Limited so that a status fits a message.
/// Simultaneous mesh uploads of all clients; each needs a temporary file.
inline constexpr std::size_t mesh_uploads_max = 16;
/// Number of recently used OBB trees that stay in memory without a running job.
inline constexpr std::size_t trees_kept_max = 8;
/// Number of distribution roots of a body at a depth that the master chooses.
inline constexpr std::uint64_t roots_chosen_max = 1u << 11;
/// If possible, the master chooses a depth at which blocks have at most this size on the wire.
inline constexpr double block_bytes_wanted = 64u << 10;
inline constexpr double wide_block_bytes_per_triangle = 10;   ///< On the wire; an estimate.
inline constexpr double binary_block_bytes_per_triangle = 30; ///< On the wire; an estimate.

// Jobs.
inline constexpr std::size_t jobs_running_max = 256;
inline constexpr std::int32_t priority_max = 10; ///< Greatest priority; the least is -10.
/// Default number of ended jobs to keep; with more, the master drops the oldest.
inline constexpr std::size_t jobs_ended_kept_max = 1024;
/// Largest number of ended jobs to keep that a setting may give.
inline constexpr std::size_t jobs_kept_max = 100'000;
/// Scenarios in all running jobs. A scenario with a result takes 52 bytes: hash, offset in a file,
/// author.
inline constexpr std::uint64_t scenarios_running_max = 1ull << 28;
/// Results of all ended jobs; each takes 16 bytes for its offset in a file. With more, the master
/// drops the oldest jobs, but never the latest.
inline constexpr std::uint64_t results_ended_kept_max = 1ull << 27;
/// For so many first scenarios of an ended job, the master keeps which worker process answered.
inline constexpr std::size_t authors_kept_max = 1u << 18;
/// Pairs that a result may count, so that the count has 56 bits. Bodies with more pairs of
/// triangles never have so many in contact or near.
inline constexpr std::uint64_t result_pairs_max = (1ull << 56) - 1;
/// Size of the job file and the packed steps of a scene, in memory and in the journal.
inline constexpr std::size_t scene_bytes_max = 8u << 20;
/// Size of a job's grid, in memory and in the journal.
inline constexpr std::size_t grid_bytes_max = 8u << 20;
/// A larger grid is dropped from memory when its job ends.
inline constexpr std::size_t ended_grid_bytes_max = 64u << 10;
inline constexpr std::size_t ignored_ranges_max = 1u << 16; ///< Ignored pairs of parts of a job.
inline constexpr std::uint32_t q_max = 1u << 16;
inline constexpr std::uint32_t v_kb_max = 16'384; ///< Limited so that a batch fits a message.
/// Size of the results that are buffered before they are written to a segment.
inline constexpr std::size_t result_buffer_bytes_max = 1u << 20;
/// Number of cuts of which a joining worker may report blocks.
inline constexpr std::size_t cuts_held_max = 1u << 15;

// Losses.
inline constexpr std::uint32_t scenario_losses_max = 3; ///< A scenario fails after so many losses.
/// If a scenario is lost repeatedly with one process, only one in so many repetitions counts.
inline constexpr std::size_t losses_again_that_count = 8;
inline constexpr std::size_t alarms_kept_max = 20;
/// Worker processes in quarantine that the master remembers. A restarted worker is a new process.
inline constexpr std::size_t quarantined_kept_max = 4096;

// Results on their way to the journal.
/// Messages of results from one worker that the master has not finished checking.
inline constexpr std::size_t results_in_hand_max = 8;
/// Size of results that wait for the disk or for their job. With more, each worker process may have
/// at most `results_in_hand_max` messages of them.
inline constexpr std::uint64_t results_aside_bytes_max = 256u << 20;
/// With so many queued rows, a commit begins at once.
inline constexpr std::size_t journal_group_rows = 256;
inline constexpr std::size_t journal_commit_rows_max = 8192;         ///< Rows in one commit.
inline constexpr std::uint64_t journal_commit_bytes_max = 64u << 20; ///< Records in one commit.
/// Size of the records queued for the journal. With more, the master reads no further results.
inline constexpr std::uint64_t journal_queue_bytes_max = 256u << 20;

// Workers.
/// With more lost workers, the master forgets those that joined first.
inline constexpr std::size_t lost_workers_kept_max = 1024;
inline constexpr std::size_t long_scenarios_shown = 16; ///< Long-running scenarios shown per job.

// Delivery of blocks.
inline constexpr std::size_t subtrees_queue_bytes_max = 16u << 20; ///< Bytes queued for one worker.
/// A worker that so many others cannot reach is no longer a source of blocks.
inline constexpr std::size_t peer_unreachable_by_max = 2;
/// A worker's request is split among at most this many peers, unless these lack some blocks.
inline constexpr std::size_t sources_of_a_request_max = 4;
/// Number of workers considered as the source of one block.
inline constexpr std::size_t sources_looked_at_max = 64;

// Dispatch.
/// Number of analysed, unsent scenarios beyond those that fill the workers' buffers.
inline constexpr std::uint64_t unsent_scenarios_max = 4096;
/// Number of analysed, unsent scenarios of a job whose policy matches by time.
inline constexpr std::uint64_t unsent_by_time_max = 1u << 18;
/// Memory of the analyses of unanswered scenarios; with more, the master starts none.
inline constexpr std::uint64_t open_analyses_bytes_max = 512u << 20;
/// With more workers, the master checks all of them less often, which bounds the cost of events.
inline constexpr std::size_t workers_few = 64;
/// Workers that an event may look at on average to count totals over all workers. So with more
/// workers the totals of ranges serve several events.
inline constexpr std::size_t workers_per_event = 16;

// Matching by time: values assumed until they are measured, and the size of batches.
inline constexpr double link_bytes_per_second_start = 125e6;  ///< 1 Gb/s.
inline constexpr std::uint64_t block_bytes_per_triangle = 16; ///< Size on the wire.
inline constexpr std::uint64_t scenario_ns_unknown = 1'000'000;
/// Batches grow if a worker's threads idle for a greater share of the time.
inline constexpr double batch_overhead_max = 0.02;
inline constexpr std::size_t batches_at_worker = 2;
/// A worker gets no range if one scenario takes it longer than this multiple of the time in which
/// the other workers finish all that is left.
inline constexpr double range_lateness_max = 1.5;
/// Number of scenarios of a job that one move takes to a worker that runs dry.
inline constexpr std::size_t moves_tried_max = 64;

// More workers.
inline constexpr std::uint32_t growth_workers_max = 1024; ///< Additional workers considered.
/// A number of additional workers is worth it if they add this part of their share of speed.
inline constexpr double growth_share_min = 0.8;

// The end of a job, when no work waits and some workers are idle.
inline constexpr double copies_share_max = 0.05; ///< Share of a job's work that may be done twice.
inline constexpr double copy_gain_min = 1.5;     ///< Least speed-up by a speculative copy.
inline constexpr std::uint32_t scenario_recalls_max = 3;
/// Number of stragglers that each check examines at most, in large clusters more.
inline constexpr std::size_t late_looked_at_min = 64;
/// In large clusters, each check examines up to one straggler per this many workers.
inline constexpr std::size_t late_looked_at_part = 16;
/// Number of idle workers tried as helpers of one straggler.
inline constexpr std::size_t helpers_tried_max = 4;

} // namespace cd::limits
