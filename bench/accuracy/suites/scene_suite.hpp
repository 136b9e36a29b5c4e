// Compares engines with the truth on whole meshes: wrong answers and time, by level of result.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

/// Results of one engine on one scene at one level.
struct QueryTotals {
    std::uint64_t queries = 0;     ///< Answered queries.
    std::uint64_t wrong_any = 0;   ///< Wrong answers to whether anything touches.
    std::uint64_t wrong_count = 0; ///< Wrong numbers of pairs, from level count on.
    /// Wrong pairs: extra ones, and missed ones by true class.
    std::array<std::uint64_t, 4> wrong{};
};

struct SceneSuiteOptions {
    std::size_t rounds = 5;
    std::chrono::seconds limit{120}; ///< Limit for one engine on one scene.
};

/// Queries every engine for every pose at each of its levels, each in its own process, then times
/// them in turn. Writes a row for each engine and level.
void run_scene(const Scene& scene,
               std::span<const TrueContacts> truth,
               std::span<const Engine> engines,
               const SceneSuiteOptions& options,
               CsvFile& csv);

[[nodiscard]] CsvFile open_queries_csv(const std::filesystem::path& folder);

} // namespace cd::bench
