// Our engine for the comparison; all knowledge of the product is in ours.cpp.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <memory>
#include <vector>

namespace cd::bench {

/// Returns the product as this host runs it, then limited to narrower SIMD.
[[nodiscard]] std::vector<Engine> our_mesh_engines();

/// Builds a mesh's search structure on so many threads, and discards it.
void build_ours(const std::shared_ptr<const Mesh>& mesh, unsigned threads);

} // namespace cd::bench
