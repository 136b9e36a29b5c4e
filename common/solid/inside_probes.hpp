// Selects the points of a body to test against the other body's solid, and the parts of that solid.
#pragma once

#include "common/tree/id_range.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Triangles of the inner body whose first corners are tested. The group represents all inner
/// triangles that are ignored with the same outer triangles.
struct ProbeGroup {
    std::vector<std::uint32_t> triangles;
    std::vector<IdRange> left_out; ///< Ignored outer triangles, ascending and disjoint.
};

struct InsideProbes {
    std::vector<ProbeGroup> groups;
    bool are_all = true; ///< False if there are triangles whose containment cannot be decided.
};

/// Chooses the points of `inner` to test against `outer`. An inner triangle is tested against the
/// outer triangles that are not ignored with it. These bound a solid if they are whole components
/// (connected by vertices) of a closed body; otherwise containment cannot be decided. An inner
/// triangle that is ignored with all outer triangles lies in no solid.
///
/// Connected inner triangles with the same ignored outer triangles lie all inside or all outside,
/// as long as no pair that is not ignored touches, so one of them is tested. Without ignored pairs,
/// that is one triangle of each component.
///
/// In `ignored`, the inner body is A. The cost is nearly linear in both bodies' triangles, times
/// the number of kinds of inner triangles (those ignored with the same outer triangles). With too
/// many kinds (limits/engine.hpp) there are no probes.
[[nodiscard]] InsideProbes
inside_probes(const ObbTree& inner, const ObbTree& outer, std::span<const IgnoredRange> ignored);

} // namespace cd
