// Our engine for the comparison; all knowledge of the product is in ours.cpp.
#pragma once

#include "bench/peers/engines/engine.hpp"
#include "common/tree/obb_tree.hpp"

#include <memory>
#include <vector>

namespace cd::bench {

/// Returns the product as this host runs it, then limited to narrower SIMD.
[[nodiscard]] std::vector<Engine> our_mesh_engines();

/// Builds a mesh's tree on so many threads, with support points, as jobs do.
std::shared_ptr<const ObbTree> build_ours(const std::shared_ptr<const Mesh>& mesh,
                                          unsigned threads);

} // namespace cd::bench
