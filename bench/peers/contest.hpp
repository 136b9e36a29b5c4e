// Runs all engines on one scene, in turns.
#pragma once

#include "bench/peers/reference.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct ContestOptions {
    std::size_t rounds = 5;  ///< Timed rounds; the result is the median for each pose.
    std::size_t passes = 20; ///< Passes over all poses for `any`; the best counts.
    std::chrono::seconds limit{
        120};                   ///< Limit for one engine to build, or for one turn over the poses.
    double budget_seconds = 30; ///< An engine that has used this up skips all further rounds.
    std::size_t judged_max = 500; ///< Disagreements per engine that the oracle judges.
    int cpu = -1;                 ///< Processor for all engines; negative: any.
};

/// One engine's times in one series of turns.
struct Heat {
    bool took_part = false;
    Ending ending = Ending::Done;
    std::size_t rounds = 0; ///< Timed rounds.
    std::size_t passes = 0;
    std::vector<double> pose_seconds; ///< Medians over the rounds; empty if none was timed.
    double pass_seconds = 0;          ///< Best pass over all poses.
};

/// Results of one engine.
struct Outcome {
    const Engine* engine = nullptr;
    Heat pairs;
    Heat any;
    double build_seconds = 0;         ///< Both bodies together.
    std::uint64_t memory_bytes = 0;   ///< Growth of its process: trees, triangles, scratch.
    std::uint64_t resident_bytes = 0; ///< As reported by the engine; 0 if unknown.
    std::uint64_t pairs_found = 0;
    std::uint64_t missing = 0; ///< Pairs of the reference that it missed.
    std::uint64_t extra = 0;   ///< Pairs that the reference lacks.
    std::uint64_t judged = 0;
    std::uint64_t ours_wrong = 0;
    std::uint64_t wrong_any = 0; ///< Number of poses.
};

/// Every engine finds all pairs of every pose; later, in fresh processes, whether there is any.
/// Engines alternate; the first one is ours.
[[nodiscard]] std::vector<Outcome> run_contest(const Scene& scene,
                                               const Reference& reference,
                                               std::span<const Engine> engines,
                                               const ContestOptions& options);

} // namespace cd::bench
