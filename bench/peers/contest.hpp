// All engines on one scene, in turns.
#pragma once

#include "bench/peers/reference.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct ContestOptions {
    std::size_t rounds = 5;          ///< Of which the medians are taken, pose by pose.
    std::size_t passes = 20;         ///< Over all poses for `any`, of which the best is taken.
    std::chrono::seconds limit{120}; ///< For one engine to build, or to run through the poses.
    double budget_seconds = 30;   ///< An engine that has used it up takes part in no further round.
    std::size_t judged_max = 500; ///< Disagreements of an engine that the oracle looks at.
    int cpu = -1;                 ///< On which all engines run; negative is any.
};

/// What one engine did in one series of turns.
struct Heat {
    bool took_part = false;
    Ending ending = Ending::Done;
    std::size_t rounds = 0; ///< Timed ones.
    std::size_t passes = 0;
    std::vector<double> pose_seconds; ///< Medians over the rounds; empty without one.
    double pass_seconds = 0;          ///< The best pass over all poses.
};

/// What became of one engine.
struct Outcome {
    const Engine* engine = nullptr;
    Heat pairs;
    Heat any;
    double build_seconds = 0;         ///< Of both bodies.
    std::uint64_t memory_bytes = 0;   ///< By which its process grew: trees, triangles, scratch.
    std::uint64_t resident_bytes = 0; ///< By its own account; 0 if it gives none.
    std::uint64_t pairs_found = 0;
    std::uint64_t missing = 0; ///< Pairs of the reference that it has not.
    std::uint64_t extra = 0;   ///< Pairs that the reference has not.
    std::uint64_t judged = 0;
    std::uint64_t ours_wrong = 0;
    std::uint64_t wrong_any = 0; ///< Poses.
    std::uint64_t box_tests = 0; ///< Over all poses, for all pairs.
    std::uint64_t triangle_tests = 0;
    TestCosts test_costs;
};

/// Every engine finds all pairs of every pose; later, in fresh processes, whether there is any.
/// Interleaved; the first engine is ours.
[[nodiscard]] std::vector<Outcome> run_contest(const Scene& scene,
                                               const Reference& reference,
                                               std::span<const Engine> engines,
                                               const ContestOptions& options);

} // namespace cd::bench
