// Decides whether two closed bodies that touch without a proper pair still penetrate each other.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/search/contact_pair.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd {

/// Decides the class `cross` for two closed bodies that touch without a proper pair. `contacts` are
/// all their contacts, sorted. Returns true if
///
/// - two coplanar triangles that overlap face the same way: their solids then share a neighbourhood
/// of the overlap. A triangle faces away from its body's solid, by parity at its centroid
/// (`SolidTest::solid_side`), so neither the winding nor a mirroring pose matters. A triangle whose
/// centroid lies on another triangle of its own body faces neither way;
/// - or a point in the interior of a contacting triangle of one body lies strictly inside the
/// other. The other's surface can meet that interior only along the surface's edges, at its
/// corners, or in coplanar triangles. These divide the interior into cells, and one point of each
/// is tested. A degenerate triangle is divided as the segment that it is.
///
/// `ignored` pairs are not among the contacts. The first rule applies to all contacts. The second
/// applies only to triangles that no ignored range names, because only their contacts are complete;
/// ignored parts that penetrate each other are not tested.
///
/// `stop` is polled throughout; once it returns true the result is meaningless.
///
/// The answer is exact. A body that a singular matrix flattens has no solid: nothing is inside it,
/// and its triangles face neither way.
[[nodiscard]] bool penetrates(const ObbTree& a,
                              const ObbTree& b,
                              const PosePair& poses,
                              std::span<const ContactPair> contacts,
                              std::span<const IgnoredRange> ignored,
                              SettleStatistics& statistics,
                              const StopCheck& stop = {});

} // namespace cd
