// Runs all engines on the distances of one scene, in turns.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/scene.hpp"
#include "bench/peers/distances/distance_engine.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

struct DistanceContestOptions {
    std::size_t rounds = 5;          ///< Timed rounds; the result is the median for each pose.
    std::chrono::seconds limit{300}; ///< Limit for one engine to build, or for one turn.
    int cpu = -1;                    ///< Processor for all engines; negative: any.
};

/// How many answers of an engine are not those of ours, and by how much.
struct DistanceErrors {
    std::uint64_t unequal = 0; ///< Not the double nearest to the distance.
    std::uint64_t off = 0;     ///< By more than 1e-12 of the largest coordinate in the world.
    std::uint64_t wrong = 0;   ///< By more than 1 %, or contact where there is none, or none.
    double worst = 0;          ///< The largest difference.

    void add(double theirs, double truth, double coordinate);
};

/// Results of one engine.
struct DistanceOutcome {
    Ending ending = Ending::Done;
    std::vector<double> pose_seconds; ///< Medians over the rounds; empty after a crash.
    std::vector<MeshDistance> found;
    DistanceErrors apart;         ///< In the poses without contact.
    DistanceErrors in_contact;    ///< In the others.
    std::uint64_t ours_wrong = 0; ///< Poses in which a pair of triangles contradicts ours.
};

/// Every engine measures the distance in every pose. Engines alternate; the first one is ours. The
/// oracle judges the pair of triangles that each engine names: no pair may be nearer than ours, and
/// our own pair is as far apart as we say.
[[nodiscard]] std::vector<DistanceOutcome>
run_distance_contest(const Scene& scene,
                     std::span<const DistanceEngine> engines,
                     const DistanceContestOptions& options);

} // namespace cd::bench
