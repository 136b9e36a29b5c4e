// Options of a search for contacts.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/distance/triangle_distance.hpp"
#include "common/pair/triangle_pair.hpp"

#include <cstdint>
#include <limits>
#include <optional>

namespace cd {

struct SearchOptions {
    bool keep_pairs = true;    ///< False: pairs are only counted.
    bool only_touches = false; ///< Keeps no pairs once any pair is proper.
    /// Keeps about twice this number of pairs at a time, and the first `pairs_max` after sorting.
    /// Counts all pairs.
    std::uint64_t pairs_max = std::numeric_limits<std::uint64_t>::max();
    /// Keeps the corners of each pair for shared or nearest points, whose computation may outlive
    /// the subtrees.
    bool keep_corners = false;
    /// Also finds near pairs: those that share no point but are at most this far apart in the
    /// world.
    std::optional<double> clearance = std::nullopt;
    /// Prepares the search for `find_nearest`, which finds no pair that is farther apart than this.
    std::optional<double> nearest_up_to = std::nullopt;
    PairStage first_stage = PairStage::Float; ///< Earlier stages are skipped.
    PairDecision decision = PairDecision::Exact;
    StopCheck stop = {}; ///< The search polls this check while it descends.
};

/// Returns the first stage of distances that corresponds to a first stage of contacts.
[[nodiscard]] constexpr DistanceStage distance_stage(PairStage stage) {
    switch (stage) {
    case PairStage::Float:
        return DistanceStage::Float;
    case PairStage::Double:
        return DistanceStage::Double;
    case PairStage::Lattice:
    case PairStage::DoubleDouble:
        return DistanceStage::DoubleDouble;
    case PairStage::WideInteger:
    case PairStage::Arbitrary:
        break;
    }
    return DistanceStage::Exact;
}

} // namespace cd
