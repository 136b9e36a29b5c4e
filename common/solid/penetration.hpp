// Whether two closed bodies that touch without a proper pair still penetrate each other.
#pragma once

#include "common/search/traverse.hpp"
#include "common/solid/point_in_solid.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd {

/// The rule of NUMERICS section 1 for `cross` without a proper pair, for two closed bodies with all
/// their contacts, sorted. True if
///
/// - two coplanar triangles that overlap face the same way: their solids then share what lies next
///   to the overlap. A triangle faces away from its body's solid, by parity at its centroid
///   (`SolidTest::solid_side`), so neither the winding nor a mirroring pose matters. One that lies
///   on another of its own body there faces neither way.
/// - or a point in the interior of a contacting triangle of one body lies strictly inside the
///   other. The other's surface can reach that interior only along its edges, or at its corners, or
///   in coplanar triangles: they divide it into cells, and a point of each is asked. A degenerate
///   triangle is divided as the segment that it is.
///
/// `ignored` pairs are not among the contacts. The first rule is for the pairs that are. The second
/// is for triangles that no ignored range names: all that the other body does to them is among the
/// contacts, and ignored parts that stick in each other are not asked.
///
/// `stop` is asked all along; what is said after a yes is of no use.
///
/// Exact. A matrix that flattens a body leaves it no solid: nothing is inside it or faces a way.
[[nodiscard]] bool penetrates(const ObbTree& a,
                              const ObbTree& b,
                              const PosePair& poses,
                              std::span<const ContactPair> contacts,
                              std::span<const IgnoredRange> ignored,
                              SettleStatistics& statistics,
                              const StopCheck& stop = {});

} // namespace cd
