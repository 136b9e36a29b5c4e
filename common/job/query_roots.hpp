// The pairs of distribution roots that a scenario needs.
#pragma once

#include "common/core/result.hpp"
#include "common/job/query.hpp"
#include "common/job/scenario.hpp"
#include "common/motion/motion_bound.hpp"
#include "common/tree/cut.hpp"

namespace cd {

/// Returns the pairs of roots under which the answer of a scenario is found, from the upper trees
/// of its bodies: those that may touch, be within the clearance, or have the nearest pair. If the
/// query asks for a distance without `up_to` and ignores triangles of the bodies, these are all
/// pairs of roots, since the triangles that bound the distance may be ignored.
///
/// For a motion, the pairs are a list of roots: each root that may come within the clearance of the
/// other body at any time occurs in at least one pair. Any root of A in the list may meet any root
/// of B in it; `CutBodies` finds the pairs that a single pose needs. `radii` are those of the
/// bodies.
///
/// Errors: as `colliding_roots`; BadInput for a motion that is none.
[[nodiscard]] Result<CollidingRoots> query_roots(const TreeTop& a,
                                                 const TreeTop& b,
                                                 const Scenario& scenario,
                                                 const Query& query,
                                                 const BodyRadii& radii = {});

} // namespace cd
