// Runs all engines on the steps of one scene, in turns.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/peers/scenes/sweep_engine.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct SweepContestOptions {
    std::size_t rounds = 3;          ///< The result is the median for each step.
    std::chrono::seconds limit{120}; ///< For one engine to take all steps.
    int cpu = -1;                    ///< Processor for all engines; negative: any.
};

/// Results of one engine.
struct SweepOutcome {
    Ending ending = Ending::Done;
    std::vector<double> step_seconds; ///< Of its processor, medians over the rounds.
    std::uint64_t pairs = 0;          ///< Left, in all steps.
    std::uint64_t missing = 0;        ///< Pairs of boxes that overlap and that it lacks.
};

/// Returns the pairs of boxes that share a point, by testing all pairs.
[[nodiscard]] std::vector<BodyPair> all_overlapping_pairs(const CrowdScene& scene,
                                                          const std::vector<Pose>& poses);

/// Counts the pairs of `wanted`, which is sorted, that `found` lacks.
[[nodiscard]] std::uint64_t count_missing(std::span<const BodyPair> wanted,
                                          std::vector<BodyPair> found);

/// Every engine takes all steps; engines alternate, and the first one is ours. Its pairs at the
/// first and the last step are compared with those of all boxes: outward rounded ones, so that an
/// engine which computes with less room may lack a pair of boxes that touch. Throws if our engine
/// does not finish.
[[nodiscard]] std::vector<SweepOutcome> run_sweep_contest(const CrowdScene& scene,
                                                          std::span<const SweepEngine> engines,
                                                          const SweepContestOptions& options);

} // namespace cd::bench
