#include "common/job/query_roots.hpp"

#include "common/core/errors.hpp"
#include "common/job/run_motion.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace cd {

namespace {

/// Returns how far apart in the world triangles may be that matter for the answer.
double reach_of(const TreeTop& a, const TreeTop& b, const Scenario& scenario, const Query& query) {
    if (query.question != Question::Distance) {
        return query.clearance.value_or(0);
    }
    const double up_to = query.up_to.value_or(std::numeric_limits<double>::infinity());
    return ignored_of(query.ignored, scenario.body_a, scenario.body_b).empty()
               ? std::min(up_to, distance_bound(a, b, scenario.poses))
               : up_to;
}

/// Returns pairs in which each root that is within `reach` of the other body's box occurs at least
/// once. Returns no pairs if a body has no such root.
Result<CollidingRoots>
motion_roots(const TreeTop& a, const TreeTop& b, const PosePair& poses, double reach) {
    const CollidingRoots of_a = CD_TRY(colliding_roots(a, whole_body(b), poses, reach));
    const CollidingRoots of_b = CD_TRY(colliding_roots(whole_body(a), b, poses, reach));
    CollidingRoots named;
    named.box_tests = of_a.box_tests + of_b.box_tests;
    if (of_a.pairs.empty() || of_b.pairs.empty()) {
        return named;
    }
    const std::size_t last_a = of_a.pairs.size() - 1;
    const std::size_t last_b = of_b.pairs.size() - 1;
    for (std::size_t i = 0; i <= std::max(last_a, last_b); ++i) {
        named.pairs.push_back(
            {of_a.pairs[std::min(i, last_a)].a, of_b.pairs[std::min(i, last_b)].b});
    }
    return named;
}

} // namespace

Result<CollidingRoots> query_roots(const TreeTop& a,
                                   const TreeTop& b,
                                   const Scenario& scenario,
                                   const Query& query,
                                   const BodyRadii& radii) {
    if (query.question == Question::Motion) {
        const Motion motion = CD_TRY(motion_of(scenario, query, radii));
        return motion_roots(a, b, motion.at_middle({}), reach_of_motion(motion, query));
    }
    return colliding_roots(a, b, scenario.poses, reach_of(a, b, scenario, query));
}

} // namespace cd
