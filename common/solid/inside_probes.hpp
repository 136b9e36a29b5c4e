// Which points of a body are asked whether they lie inside another one, and inside what of it.
#pragma once

#include "common/tree/id_range.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Triangles of the inner body, of each the first corner is asked; they stand for all that is
/// ignored with the same triangles of the outer body.
struct ProbeGroup {
    std::vector<std::uint32_t> triangles;
    std::vector<IdRange> left_out; ///< Of the outer body; ascending, apart.
};

struct InsideProbes {
    std::vector<ProbeGroup> groups;
    bool are_all = true; ///< False: there are triangles of which nothing can be said.
};

/// A triangle of the inner body meets those of the outer one that are not ignored with it. These
/// bound a solid where they are whole components (connected by vertices) of a closed body, and then
/// it can be told whether the triangle lies in that. A triangle that meets none lies in nothing.
///
/// Triangles that meet the same, and are connected by such triangles, lie all inside or all
/// outside, as long as nothing that meets touches: one of them is asked. Without ignored pairs that
/// is one of each component.
///
/// `ignored` has the ranges of the inner body as those of A. Near linear in both bodies'
/// triangles, times the kinds of triangles of the inner body by what they meet. Of too many kinds
/// (limits/engine.hpp) nothing is asked.
[[nodiscard]] InsideProbes
inside_probes(const ObbTree& inner, const ObbTree& outer, std::span<const IgnoredRange> ignored);

} // namespace cd
