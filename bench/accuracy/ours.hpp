// Our settings, as engines for the comparison.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <vector>

namespace cd::bench {

/// Returns the settings from the cheapest to the exact one, which comes last. Before it come the
/// runs of the exact setting on each SIMD target not in use.
[[nodiscard]] std::vector<Engine> our_engines();

/// Name of the exact setting.
inline constexpr const char* certified = "cdcluster, certified";

} // namespace cd::bench
