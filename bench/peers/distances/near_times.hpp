// Times searches with a clearance, and the float stage of their decisions on each SIMD target.
#pragma once

#include "bench/accuracy/suites/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cd::bench {

/// What floats take on one SIMD target to compare the distances of candidates with a clearance.
struct NearFloats {
    std::string target;
    std::uint64_t candidates = 0; ///< Those that share no point, of all poses.
    std::uint64_t unknown = 0;    ///< Those that floats leave to doubles.
    double candidate_ns = 0;      ///< Median over the rounds, of processor time.
};

/// Measures all SIMD targets of this processor in turns. The bodies have wide trees. The candidates
/// are those of a search for all pairs within the clearance, without pairs in contact, which the
/// search decides before.
[[nodiscard]] std::vector<NearFloats>
measure_near_floats(const Scene& scene, double clearance, std::size_t rounds);

/// Returns the time, the median over the rounds, that each pose of the scene takes to tell whether
/// any pair is within the clearance.
[[nodiscard]] std::vector<double>
measure_near_queries(const Scene& scene, double clearance, std::size_t rounds);

} // namespace cd::bench
