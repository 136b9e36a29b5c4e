// Selects the points of a body to test against the other body's solid, and the parts of that solid.
#pragma once

#include "common/tree/id_range.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Triangles of the inner body whose first corners are tested. They represent all triangles that
/// are ignored with the same triangles of the outer body.
struct ProbeGroup {
    std::vector<std::uint32_t> triangles;
    std::vector<IdRange> left_out; ///< Ranges of the outer body; ascending and disjoint.
};

struct InsideProbes {
    std::vector<ProbeGroup> groups;
    bool are_all = true; ///< False if there are triangles whose containment cannot be decided.
};

/// A triangle of the inner body meets those triangles of the outer body that are not ignored with
/// it. They bound a solid where they are whole components (connected by vertices) of a closed body;
/// only then can it be decided whether the triangle lies in that solid. A triangle that meets none
/// lies in no solid.
///
/// Connected triangles that meet the same outer triangles lie all inside or all outside, as long as
/// no pair that is not ignored touches: one of them is tested. Without ignored pairs that is one of
/// each component.
///
/// `ignored` has the ranges of the inner body as those of A. The cost is nearly linear in both
/// bodies' triangles, times the number of kinds of inner triangles by what they meet. With too many
/// kinds (limits/engine.hpp) there are no probes.
[[nodiscard]] InsideProbes
inside_probes(const ObbTree& inner, const ObbTree& outer, std::span<const IgnoredRange> ignored);

} // namespace cd
