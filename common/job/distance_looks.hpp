// The two looks at a scenario that asks for the distance: at its nearest pairs of roots, then at
// the other pairs that may be nearer than what was found.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/job/query.hpp"
#include "common/tree/cut.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Number of root pairs of a first look.
inline constexpr std::size_t first_look_pairs = 4;

/// Whether a scenario with these root pairs (`query_roots`) has a first look: if it asks for the
/// distance, and has more pairs than a first look.
[[nodiscard]] bool looks_twice(const Query& query, std::span<const RootPair> pairs);

/// Returns the `first_look_pairs` pairs whose boxes are nearest, nearest first, by the spheres
/// around the boxes. That is an estimate, on which no answer depends.
[[nodiscard]] std::vector<RootPair> first_look(const TreeTop& a,
                                               const TreeTop& b,
                                               const PosePair& poses,
                                               std::span<const RootPair> pairs);

/// Returns those of the pairs that may have triangles whose distance in the world rounds to at most
/// `found`, in order. Together they have the answer of all pairs, if two triangles of the bodies,
/// not ignored, have the distance `found`. Without `found`, returns all pairs.
[[nodiscard]] std::vector<RootPair> second_look(const TreeTop& a,
                                                const TreeTop& b,
                                                const PosePair& poses,
                                                std::vector<RootPair> pairs,
                                                std::optional<double> found);

} // namespace cd
