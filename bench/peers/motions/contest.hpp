// Runs all engines on the paths of one scene, in turns.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/peers/motions/motion_engine.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct MotionContestOptions {
    std::size_t rounds = 3;         ///< The result is the median for each path.
    std::chrono::seconds limit{20}; ///< For one path, and to build.
    double budget_seconds = 30;     ///< An engine that has used more tries no further path.
    int cpu = -1;                   ///< Processor for all engines; negative: any.
};

/// What an engine has found on one path.
struct PathOutcome {
    bool is_tried = false; ///< False if it was out of budget, or had crashed or hung several times.
    Ending ending = Ending::Done;
    double seconds = 0; ///< Of its processor, the median; 0 after a crash or a hang.
    Impact impact;
};

/// Every engine finds the impacts on all paths; engines alternate, and the first one is ours.
/// Returns each engine's outcomes by path. Throws if our engine does not finish a path: without its
/// answers there is no report.
[[nodiscard]] std::vector<std::vector<PathOutcome>>
run_motion_contest(const MotionScene& scene,
                   std::span<const MotionEngine> engines,
                   const MotionContestOptions& options);

/// How an engine's impacts differ from what ours has proven.
struct ImpactErrors {
    std::uint64_t unanswered = 0; ///< Paths on which it crashed or hung.
    std::uint64_t missed = 0;     ///< Impacts of ours that it does not tell.
    std::uint64_t invented = 0;   ///< Impacts on paths that ours has proven free.
    /// Of the impacts that both tell, the share of the path by which its time is outside of the
    /// bracket of ours: below 0 before it, above 0 behind it.
    std::vector<double> shares_off;
};

/// Compares outcomes by path. Paths that ours leaves undecided, and those that
/// they have not tried, count nowhere.
[[nodiscard]] ImpactErrors compare_impacts(std::span<const PathOutcome> ours,
                                           std::span<const PathOutcome> theirs);

} // namespace cd::bench
