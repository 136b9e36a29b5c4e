// Runs all engines on the lines of one scene, in turns.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/peers/shots/shot_engine.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct ShotContestOptions {
    std::size_t rounds = 3;           ///< Timed rounds; the result is the median.
    std::chrono::seconds limit{60};   ///< Limit for one engine to build, or for one turn.
    int cpu = -1;                     ///< Processor for all engines; negative: any.
    std::uint64_t judged_max = 10000; ///< Lines of each engine that the oracle judges.
};

/// Results of one engine.
struct ShotOutcome {
    Ending ending = Ending::Done;
    double seconds = 0;        ///< Of its processor, for all lines; 0 after a crash.
    std::uint64_t hits = 0;    ///< Of ours, the crossings.
    std::uint64_t missing = 0; ///< See `compare_hits`.
    std::uint64_t doubled = 0;
    std::uint64_t wrong_lines = 0; ///< Lines with missing or doubled hits.
    std::uint64_t odd_lines = 0;   ///< Lines with an odd number of hits.
    std::uint64_t judged = 0;      ///< Wrong lines that the oracle has judged.
    std::uint64_t ours_wrong = 0;  ///< Those of them in which ours is not exactly right.
};

/// Every engine finds all hits of all lines. Engines alternate; the first one is ours. Where the
/// hits of another engine differ from ours, the oracle judges ours. Throws if our engine does not
/// finish: without its answers there is no report.
[[nodiscard]] std::vector<ShotOutcome> run_shot_contest(const ShotScene& scene,
                                                        std::span<const ShotEngine> engines,
                                                        const ShotContestOptions& options);

} // namespace cd::bench
