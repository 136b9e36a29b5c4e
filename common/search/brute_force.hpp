// The slow twin of the contact search: tests every triangle of A against every triangle of B.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/search/contact_pair.hpp"

#include <vector>

namespace cd {

/// Returns all pairs of a triangle of A and a triangle of B that share a point, ascending.
[[nodiscard]] std::vector<ContactPair>
contact_pairs_brute_force(const Mesh& a, const Mesh& b, const PosePair& poses);

} // namespace cd
