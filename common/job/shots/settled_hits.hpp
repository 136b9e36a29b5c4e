// Hits of a scenario that need no further decision.
#pragma once

#include "common/job/result/pair_hit.hpp"
#include "common/search/contact_pair.hpp"

#include <vector>

namespace cd {

/// Pairs of triangles and lines, ascending, each with its hit.
struct SettledHits {
    std::vector<ContactPair> pairs;
    std::vector<PairHit> hits;
};

} // namespace cd
