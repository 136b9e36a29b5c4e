// Every bound of the system on one page. Each limit names what it protects.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

// Frames. Checked against the header before anything is allocated.
inline constexpr std::uint32_t frame_control_bytes_max = 1u << 20; ///< Any message but data.
inline constexpr std::uint32_t frame_data_bytes_max = 4u << 20;    ///< Blocks, poses, results.
inline constexpr std::size_t write_queue_bytes_max = 64u << 20;    ///< Then the sender waits.

// Geometry.
inline constexpr std::uint64_t mesh_vertices_max = 1ull << 31;
inline constexpr std::uint64_t mesh_triangles_max = 1ull << 31;
inline constexpr std::uint64_t mesh_bytes_max = 8ull << 30;
inline constexpr std::uint32_t parts_max = 1u << 20;
inline constexpr std::uint32_t distribution_depth_max = 20;
inline constexpr std::uint64_t subtree_block_bytes_max = 1ull << 30;
inline constexpr std::size_t mesh_uploads_max = 16; ///< At a time; each is a temporary file.
inline constexpr std::size_t trees_kept_max = 8;    ///< That no job uses any more.

// Jobs.
inline constexpr std::uint64_t scenarios_max = 1ull << 40;
inline constexpr std::uint32_t root_pairs_max = 1u << 22; ///< Per scenario; more is an error.
inline constexpr std::uint64_t result_record_bytes_max = 1ull << 32;
inline constexpr std::uint32_t q_max = 1u << 16;
inline constexpr std::uint64_t analysis_block_scenarios = 256;
inline constexpr std::uint64_t spool_run_scenarios = 4096;       ///< On disk together.
inline constexpr std::size_t result_buffer_bytes_max = 1u << 20; ///< Not yet written to a file.

// Time.
inline constexpr std::chrono::seconds heartbeat_period{2};
inline constexpr std::chrono::seconds peer_lost_after{15};
inline constexpr std::chrono::seconds connect_timeout{10};

} // namespace cd::limits
