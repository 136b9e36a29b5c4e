// Bounds of HTTP answers and of the page.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cd::limits {

// HTTP.
inline constexpr std::size_t http_piece_bytes = 256u << 10; ///< Bytes of a body written at a time.

/// A page that is read whole, such as /metrics of a master with thousands of workers.
inline constexpr std::uint64_t http_page_bytes_max = 64u << 20;
inline constexpr std::size_t http_connections_max = 256; ///< Of the master's --http port.

// Arrays of the page.
/// Scenarios in one array of classes or counts.
inline constexpr std::uint64_t page_classes_max = 1u << 20;
/// Scenarios in one array of poses; on a master, in any array.
inline constexpr std::uint64_t page_scenarios_max = 1u << 16;
inline constexpr std::uint64_t page_sample_max = 4096; ///< Scenarios in a sample.
inline constexpr std::size_t page_groups_max = 1000;   ///< Pairs of parts in a job's description.
/// Above so many bodies beside a pair, the page draws boxes (`othersMax` of step_bodies.ts).
inline constexpr std::size_t page_other_bodies_max = 200;
/// Pairs, or shared points, of one scenario.
inline constexpr std::uint64_t page_rows_max = 1'000'000;
/// A results folder with more scenarios cannot be viewed: its index takes 5 bytes for each.
inline constexpr std::uint64_t page_index_scenarios_max = 1u << 28;

// Scenarios that are run again for the page.
inline constexpr std::size_t page_runs_waiting_max = 4; ///< Further runs are refused.
/// Number of scenarios whose contacts are kept, since the page asks for them in several requests.
inline constexpr std::size_t page_runs_kept = 4;

// History.
inline constexpr std::size_t history_samples_max = 600; ///< Ten minutes.

// Requests.
inline constexpr std::size_t page_name_bytes_max = 4096; ///< A name in a query.

// `cdctl view`.
inline constexpr std::size_t view_connections_max = 128; ///< Connections of one request each.

} // namespace cd::limits
