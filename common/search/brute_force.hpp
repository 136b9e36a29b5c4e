// The slow twin of the traversal: every triangle against every other. Obviously right.
#pragma once

#include "common/search/traverse.hpp"

namespace cd {

/// All contact pairs, sorted.
[[nodiscard]] std::vector<ContactPair>
contact_pairs_brute_force(const Mesh& a, const Mesh& b, const PosePair& poses);

} // namespace cd
