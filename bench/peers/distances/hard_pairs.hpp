// The engines' tests of two triangles on pairs whose distance floating point misjudges.
#pragma once

#include "bench/peers/distances/contest.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd::bench {

/// One kind of pairs and one engine.
struct PairDistances {
    std::string kind;
    std::string engine;
    std::uint64_t pairs = 0; ///< Those that share no point.
    DistanceErrors errors;   ///< Against the exact oracle.
};

/// Asks each engine that has a test of triangles for the distance of `count` pairs of each kind of
/// `distance_pair_makers`.
[[nodiscard]] std::vector<PairDistances> measure_hard_pairs(std::span<const DistanceEngine> engines,
                                                            std::uint64_t count);

} // namespace cd::bench
