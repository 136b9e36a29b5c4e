// Engines against the truth on whole meshes: wrong answers and time, by level of result.
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

/// What became of one engine on one scene at one level.
struct QueryTotals {
    std::uint64_t queries = 0;            ///< Answered.
    std::uint64_t wrong_any = 0;          ///< Whether anything touches was answered wrongly.
    std::uint64_t wrong_count = 0;        ///< The number of pairs was wrong, from level count on.
    std::uint64_t pairs_found = 0;        ///< Without repetitions, from level pairs on.
    std::array<std::uint64_t, 4> wrong{}; ///< Pairs: invented, and missed by true class.
    std::uint64_t record_bytes = 0;
    std::uint64_t read_bytes = 0;
};

struct SceneSuiteOptions {
    std::size_t rounds = 5;
    std::chrono::seconds limit{120}; ///< For one engine on one scene.
};

/// Asks every engine about every pose at each of its levels, each engine in a process of its own;
/// then times them all in turn. Writes a row an engine and level.
void run_scene(const Scene& scene,
               std::span<const TrueContacts> truth,
               std::span<const Engine> engines,
               const SceneSuiteOptions& options,
               CsvFile& csv);

[[nodiscard]] CsvFile open_queries_csv(const std::filesystem::path& folder);

} // namespace cd::bench
