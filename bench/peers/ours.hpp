// Our engine beside the peers. Everything that the comparison knows of it stands in ours.cpp.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <memory>
#include <vector>

namespace cd::bench {

/// The product as this host runs it, which stands first; then the same held to narrower SIMD.
[[nodiscard]] std::vector<Engine> our_mesh_engines();

/// Builds what a mesh is searched by, on so many threads, and throws it away.
void build_ours(const std::shared_ptr<const Mesh>& mesh, unsigned threads);

} // namespace cd::bench
