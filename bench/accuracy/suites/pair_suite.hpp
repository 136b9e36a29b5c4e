// Compares engines with the truth on pairs of triangles: wrong answers, symmetry, time.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/pair_batch.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cd::bench {

/// Results of one engine on one category, by the pairs' true class.
struct PairTotals {
    std::array<std::uint64_t, 4> pairs{}; ///< Answered pairs.
    /// Wrong answers: contact for apart, and apart for contact.
    std::array<std::uint64_t, 4> wrong{};
    std::uint64_t wrong_class = 0;   ///< Contact correctly found, but in another class.
    std::uint64_t swap_differs = 0;  ///< Different answers with A and B swapped.
    std::uint64_t order_differs = 0; ///< Different answers with the corners reordered.
    std::uint64_t unanswered = 0;    ///< Unanswered after a crash or a hang.
    Ending ending = Ending::Done;
    double seconds_a_pair = 0; ///< Mean over `pairs_timed`; 0 if not timed.

    void add(const PairTotals& other);
};

struct PairSuiteOptions {
    unsigned threads = 1;   ///< Threads of the oracle.
    std::size_t rounds = 5; ///< Timed rounds; 0: none.
    std::size_t pairs_timed = 2000;
    std::chrono::seconds limit{60}; ///< Limit for one engine on one chunk.
};

/// Returns the next pairs of a category, or none at its end.
using ChunkMaker = std::function<PairBatch()>;

/// Queries every engine for every pair of the category, each in its own process; skips engines that
/// crashed or hung. Then times the first pairs, all engines in turn. Writes and returns a row for
/// each engine.
std::vector<PairTotals> run_category(const std::string& suite,
                                     const std::string& category,
                                     const ChunkMaker& next_chunk,
                                     std::span<const Engine> engines,
                                     const PairSuiteOptions& options,
                                     CsvFile& csv);

[[nodiscard]] CsvFile open_pairs_csv(const std::filesystem::path& folder);

} // namespace cd::bench
