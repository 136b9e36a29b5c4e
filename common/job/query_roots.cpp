#include "common/job/query_roots.hpp"

#include "common/core/errors.hpp"
#include "common/job/run_motion.hpp"

#include <algorithm>
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

} // namespace

Result<CollidingRoots> query_roots(const TreeTop& a,
                                   const TreeTop& b,
                                   const Scenario& scenario,
                                   const Query& query,
                                   const BodyRadii& radii) {
    if (query.question == Question::Motion) {
        const Motion motion = CD_TRY(motion_of(scenario, query, radii));
        return colliding_roots(a, b, motion.at_middle({}), reach_of_motion(motion, query));
    }
    return colliding_roots(a, b, scenario.poses, reach_of(a, b, scenario, query));
}

} // namespace cd
