// Engines against the truth on pairs of triangles: wrong answers, symmetry, time.
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

/// What became of one engine on one category, by the true class of the pairs.
struct PairTotals {
    std::array<std::uint64_t, 4> pairs{}; ///< Answered.
    std::array<std::uint64_t, 4> wrong{}; ///< Of them: contact where apart, apart where contact.
    std::uint64_t wrong_class = 0;        ///< Contact rightly, but of another class.
    std::uint64_t swap_differs = 0;       ///< Another answer with A and B swapped.
    std::uint64_t order_differs = 0;      ///< Another answer with the corners in another order.
    std::uint64_t unanswered = 0;         ///< After a crash or a hang.
    Ending ending = Ending::Done;
    double seconds_a_pair = 0; ///< Of `pairs_timed`; 0 where nothing was timed.

    void add(const PairTotals& other);
};

struct PairSuiteOptions {
    unsigned threads = 1;   ///< Of the oracle.
    std::size_t rounds = 5; ///< Of timing; 0 for none.
    std::size_t pairs_timed = 2000;
    std::chrono::seconds limit{60}; ///< For one engine on one chunk.
};

/// Gives the next pairs of a category, and none at its end.
using ChunkMaker = std::function<PairBatch()>;

/// Asks every engine about every pair of the category, each in a process of its own; an engine that
/// crashed or hung is asked no more. The first pairs are then timed, all engines in turn. Writes a
/// row an engine and returns them.
std::vector<PairTotals> run_category(const std::string& suite,
                                     const std::string& category,
                                     const ChunkMaker& next_chunk,
                                     std::span<const Engine> engines,
                                     const PairSuiteOptions& options,
                                     CsvFile& csv);

[[nodiscard]] CsvFile open_pairs_csv(const std::filesystem::path& folder);

} // namespace cd::bench
