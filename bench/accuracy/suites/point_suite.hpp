// Compares the contact points of engines with the exact ones.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/pair_batch.hpp"

#include <chrono>
#include <span>
#include <string>

namespace cd::bench {

/// Queries each engine that returns points, in its own process, for up to `pairs_max` contacts of
/// the batch. Writes a row for each engine: the share of correctly rounded points, the distance of
/// points from the exact set, and the distance of exact corners from the nearest point, in longest
/// edges and in model units.
void run_points(const std::string& category,
                const PairBatch& batch,
                std::size_t pairs_max,
                std::span<const Engine> engines,
                std::chrono::seconds limit,
                CsvFile& csv);

[[nodiscard]] CsvFile open_points_csv(const std::filesystem::path& folder);

} // namespace cd::bench
