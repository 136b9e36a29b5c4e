// Every bound of the system; some stand in limits_*.hpp. Each names what it protects.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Messages. A type's cap is checked while its frames come in, before more is kept (PROTOCOL.md).
inline constexpr std::uint64_t message_control_bytes_max = 1u << 20;
inline constexpr std::uint64_t message_roots_bytes_max = 8u << 20; ///< Lists of roots of one tree.
inline constexpr std::uint64_t message_part_bytes_max = 16u << 20; ///< Of what a client submits.
inline constexpr std::uint64_t message_data_bytes_max = 64u << 20; ///< Batches.
inline constexpr std::uint64_t message_results_bytes_max = 257u << 20;   ///< One largest record.
inline constexpr std::uint64_t message_subtrees_bytes_max = 1025u << 20; ///< One largest block.
inline constexpr std::size_t streams_max = 4; ///< Messages begun by one of whom no role is known.
inline constexpr std::size_t hello_text_bytes_max = 256;
inline constexpr std::size_t write_queue_bytes_max = 64u << 20; ///< Then the sender waits.

// Identity.
inline constexpr std::size_t certificate_bytes_max = 16u << 10; ///< One PEM text.
inline constexpr std::size_t certified_name_bytes_max = 64;     ///< RFC 5280's bound, too.
inline constexpr std::chrono::hours authority_life{24 * 3650};
inline constexpr std::chrono::minutes clock_difference_max{5}; ///< Of two hosts; for certificates.
inline constexpr std::chrono::hours master_certificate_life{24 * 30};
inline constexpr std::chrono::hours certificate_life{24 * 7}; ///< Of others, unless told.
inline constexpr std::chrono::seconds certificate_life_min{2};
inline constexpr std::chrono::minutes renewal_check_period{1};
inline constexpr std::chrono::seconds renewal_retry_min{1};
inline constexpr std::size_t tokens_max = 1024; ///< Neither expired nor forgotten.
inline constexpr std::uint32_t token_uses_max = 100'000;
inline constexpr std::chrono::hours token_life_max{24 * 30};
inline constexpr std::uint64_t tls_key_bytes_max = 64ull << 30; ///< Then a new key is agreed on.

// Files.
inline constexpr std::uint64_t npz_array_bytes_max = 16ull << 30; ///< One array, unpacked.
inline constexpr std::uint64_t tree_cache_bytes_max = 4ull << 30; ///< Trees kept between runs.
inline constexpr std::size_t mesh_file_depth_max = 1000; ///< Nested nodes: importers recurse.

// Geometry.
inline constexpr std::uint64_t mesh_vertices_max = 1ull << 31;
inline constexpr std::uint64_t mesh_triangles_max = 1ull << 31;
inline constexpr std::uint64_t mesh_bytes_max = 8ull << 30;
inline constexpr std::uint32_t parts_max = 1u << 20;
inline constexpr std::uint32_t distribution_depth_max = 20;
inline constexpr std::uint64_t roots_chosen_max = 1u << 11; ///< Of a body whose depth nobody gave.
inline constexpr std::uint64_t subtree_block_bytes_max = 1ull << 30;
inline constexpr double block_bytes_wanted = 64u << 10;       ///< On the wire, of such a body.
inline constexpr double wide_block_bytes_per_triangle = 10;   ///< On the wire; an estimate.
inline constexpr double binary_block_bytes_per_triangle = 30; ///< Of the other form of subtrees.
inline constexpr unsigned wide_tree_depth_max = 100; ///< A node has at most 3/4 of its parent's.
inline constexpr std::size_t mesh_uploads_max = 16;  ///< At a time; each is a temporary file.
inline constexpr std::size_t trees_kept_max = 8;     ///< That no job uses any more.

// Jobs.
inline constexpr std::uint64_t scenarios_max = 1ull << 40;
inline constexpr std::uint32_t root_pairs_max = 1u << 22; ///< Per scenario; more is an error.
inline constexpr std::uint64_t result_record_bytes_max = 1ull << 28; ///< Fits a message.
inline constexpr std::uint32_t q_max = 1u << 16;
/// Within such a window neighbours are handed out that touch the same parts.
inline constexpr std::uint64_t order_window_scenarios = 1u << 16;
inline constexpr std::uint64_t range_scenarios_max = 1u
                                                     << 14; ///< Sent without an analysis, at once.
inline constexpr std::uint64_t analysis_block_scenarios = 256;
inline constexpr std::uint64_t spool_run_scenarios = analysis_block_scenarios; ///< Read together.
inline constexpr std::size_t result_buffer_bytes_max = 1u << 20; ///< Not yet written to a file.
inline constexpr std::uint32_t scenario_losses_max = 3; ///< Workers that a scenario may take down.

// The master.
inline constexpr std::size_t connections_max = 8192;
inline constexpr std::size_t greetings_max = 512; ///< Connections that nobody has greeted on yet.
inline constexpr std::size_t client_connections_max = 64;
inline constexpr std::size_t client_jobs_max = 64;
inline constexpr std::uint64_t client_bytes_max = 256ull << 30; ///< Sent in a day.
inline constexpr std::chrono::hours client_bytes_period{24};
inline constexpr std::size_t jobs_running_max = 256;
inline constexpr std::size_t jobs_ended_kept_max =
    1024; ///< With their results; then the oldest goes, unless the master is told otherwise.
inline constexpr std::size_t jobs_kept_max = 100'000; ///< As many as it may be told.
inline constexpr std::chrono::seconds retention_check_period{30};
inline constexpr std::size_t authors_kept_max = 1u << 18; ///< Of scenarios of a job that has ended.
inline constexpr std::uint32_t v_kb_max = 16'384;         ///< So that a batch fits a message.
inline constexpr std::size_t ignored_ranges_max = 1u << 16; ///< They go with each batch.
inline constexpr std::uint64_t unsent_scenarios_max = 4096; ///< Analysed, beyond the buffers.
inline constexpr std::uint64_t open_analyses_bytes_max = 512u << 20; ///< Unanswered, in memory.
inline constexpr std::size_t subtrees_bytes_min = 1u << 20; ///< Blocks are gathered up to this.
inline constexpr std::size_t subtrees_queue_bytes_max = 16u << 20; ///< Towards one worker.
inline constexpr std::size_t results_in_hand_max = 8; ///< Messages of one worker, being checked.
inline constexpr std::uint64_t results_bytes_max = 512u << 20; ///< Of one message, uncompressed.
inline constexpr std::uint64_t results_scan_max = 1u << 20;    ///< Scenarios looked at for one.
inline constexpr std::uint64_t results_part_bytes_target = 4u << 20; ///< To a client, uncompressed.
inline constexpr std::size_t watches_max = 64;                       ///< Of one client at a time.
inline constexpr std::size_t peer_sources_max = 3;                   ///< Named for one fetch.
inline constexpr std::size_t peer_unreachable_by_max = 2; ///< Then nobody is sent there any more.

// The journal.
inline constexpr std::size_t journal_group_rows = 256; ///< Then a commit waits no longer.
inline constexpr std::chrono::milliseconds journal_group_period{5};  ///< Between two commits.
inline constexpr std::size_t journal_commit_rows_max = 8192;         ///< In one commit,
inline constexpr std::uint64_t journal_commit_bytes_max = 64u << 20; ///< and of records.
inline constexpr std::uint64_t journal_queue_bytes_max = 256u
                                                         << 20; ///< Then workers are read later.
inline constexpr std::chrono::milliseconds journal_retry_period{500}; ///< With a full disk.

// Matching by time. What is not measured yet is taken to be so.
inline constexpr double link_bytes_per_second_start = 125e6;  ///< 1 Gb/s.
inline constexpr double block_seconds = 20e-6;                ///< To ask for a block and open it.
inline constexpr std::uint64_t block_bytes_per_triangle = 16; ///< On the wire.
inline constexpr std::uint64_t scenario_ns_unknown = 1'000'000;
inline constexpr double batch_seconds_start = 0.1;
inline constexpr double batch_seconds_min = 0.001;
inline constexpr double batch_seconds_max = 1;
inline constexpr double batch_overhead_max = 0.02; ///< Above it batches grow.
inline constexpr std::size_t batches_at_worker = 2;
inline constexpr double scenario_seconds_long = 0.05; ///< Against which a round trip is nothing.
inline constexpr std::size_t moves_tried_max = 64; ///< At a time, towards one worker that runs dry.
inline constexpr std::uint64_t unsent_by_time_max = 1u << 18; ///< Analysed ahead of the workers.

// The end of a job, when nothing waits and some workers have nothing to do.
inline constexpr double copies_share_max = 0.05;     ///< Of a job's work: what may be done twice.
inline constexpr double copy_gain_min = 1.5;         ///< So many times sooner a copy has to end.
inline constexpr double end_gain_seconds_min = 0.02; ///< Less is not worth the messages.
inline constexpr double recall_answer_seconds = 0.5; ///< Then nobody waits for what is recalled.
inline constexpr std::uint32_t scenario_recalls_max = 3;
inline constexpr std::chrono::milliseconds end_check_period{100}; ///< Is anybody late?

// The worker.
inline constexpr std::uint64_t wide_bytes_per_triangle = 48;    ///< In memory; an estimate.
inline constexpr std::uint64_t binary_bytes_per_triangle = 128; ///< Of the other form of subtrees.
inline constexpr std::size_t results_flush_bytes = 1u << 20;    ///< Uncompressed, of one task.
inline constexpr std::chrono::milliseconds results_flush_period{50};
inline constexpr double walk_seconds = 0.001; ///< What a thread walks at once.
inline constexpr std::size_t walk_scenarios_max = 256;
inline constexpr std::size_t walked_waiting_max = 4096; ///< For subtrees; then nothing is walked.
inline constexpr std::uint64_t results_unkept_bytes_max = 64u << 20; ///< Not acknowledged;
inline constexpr std::size_t results_unkept_messages_max = 1u << 14; ///< then it begins nothing.
inline constexpr std::chrono::seconds results_kept_wait_max{5};      ///< When it drains.
inline constexpr std::chrono::minutes parked_trees_kept{10}; ///< Of a session before, unused.
inline constexpr std::size_t jobs_per_thread_max = 4;        ///< Begun or queued for the threads.
inline constexpr std::uint32_t worker_threads_max = 4096;
inline constexpr std::size_t peer_uploads_max = 2;        ///< That one worker serves at a time.
inline constexpr std::size_t peer_connections_max = 64;   ///< From other workers; then they wait.
inline constexpr std::size_t peer_channels_kept_max = 16; ///< To other workers, for the next fetch.
inline constexpr std::size_t peer_tickets_remembered = 1u << 16; ///< Older ones are not taken.
inline constexpr double worker_weight_max = 1000;                ///< Of one worker's speed.
inline constexpr std::chrono::milliseconds reconnect_after_min{100};
inline constexpr std::chrono::milliseconds reconnect_after_max{5000};

// Time.
inline constexpr std::chrono::seconds heartbeat_period{2};
inline constexpr std::chrono::milliseconds heartbeat_period_min{10};
inline constexpr unsigned heartbeats_missed_max = 3; ///< Then a worker gets no new work.
inline constexpr std::chrono::seconds peer_lost_after{15};
inline constexpr std::chrono::hours peer_lost_after_max{24};
inline constexpr std::chrono::minutes worker_forgotten_after{10}; ///< From its last word on.
inline constexpr std::size_t lost_workers_kept_max = 1024;        ///< Then the oldest goes.
inline constexpr double scenario_seconds_shown = 10;    ///< Who takes longer is named in a status.
inline constexpr std::size_t long_scenarios_shown = 16; ///< Of one job.
inline constexpr std::chrono::seconds connect_timeout{10};
inline constexpr std::chrono::seconds peer_connect_timeout{2}; ///< Workers; then the next source.
inline constexpr std::chrono::seconds peer_answer_max{5};      ///< Between two messages of a peer.
inline constexpr std::chrono::seconds peer_fetch_max{60};      ///< Of one fetch, in all.
inline constexpr std::chrono::seconds peer_wait_max{10};       ///< For a block that others hold.
inline constexpr std::chrono::seconds peer_idle_max{60};       ///< A peer's connection without use.
inline constexpr std::chrono::milliseconds peer_check_period{500};
inline constexpr std::chrono::seconds answer_timeout{30}; ///< A client's, for what takes no work.
inline constexpr std::chrono::seconds mesh_stored_timeout{3600}; ///< And for what does.
inline constexpr std::chrono::hours client_idle_max{24};
inline constexpr std::chrono::milliseconds watch_period{200};
inline constexpr std::chrono::seconds cancel_wait_max{10}; ///< For the disk.
inline constexpr std::chrono::milliseconds accept_retry_period{100};
inline constexpr std::chrono::seconds stop_grace{5}; ///< For what is under way when a program ends.
inline constexpr std::chrono::seconds write_stall_max{30}; ///< One frame; then the peer is lost.
inline constexpr std::chrono::seconds close_flush_max{5};  ///< For what is queued at a close.
inline constexpr std::chrono::seconds read_stall_max{30};  ///< For the rest of a begun frame.

} // namespace cd::limits
