// The hash with which the digest of a scene starts.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/job/result/merge.hpp"
#include "common/scene/pair_set.hpp"
#include "common/tree/ignored_range.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Hashes what decides which pairs of bodies and of triangles a scene tests: for each body its mesh
/// and whether it is fixed, the number of steps, the ignored pairs of bodies, and the ignored
/// triangles of others. Names and poses are no part of it. All lists are by body, of one length.
[[nodiscard]] SceneHead scene_head(std::span<const Sha256> meshes,
                                   const std::vector<bool>& are_fixed,
                                   std::uint64_t steps,
                                   const PairSet& ignored,
                                   std::span<const IgnoredRange> ranges);

} // namespace cd
