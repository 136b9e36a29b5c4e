// The points of contact that engines give, against the exact ones.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/pair_batch.hpp"

#include <chrono>
#include <span>
#include <string>

namespace cd::bench {

/// Takes up to `pairs_max` pairs of the batch that are in contact and asks each engine that gives
/// points for theirs, in a process of its own. Writes a row an engine: how many points are the
/// correctly rounded ones, how far points stray from the exact set, and how far the exact set's
/// corners are from the nearest point, as shares of the longest edge and in model units.
void run_points(const std::string& category,
                const PairBatch& batch,
                std::size_t pairs_max,
                std::span<const Engine> engines,
                std::chrono::seconds limit,
                CsvFile& csv);

[[nodiscard]] CsvFile open_points_csv(const std::filesystem::path& folder);

} // namespace cd::bench
