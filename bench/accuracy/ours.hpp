// Our settings, as engines beside the others.
#pragma once

#include "bench/peers/engines/engine.hpp"

#include <vector>

namespace cd::bench {

/// The settings from the cheapest to the exact one, which stands last; before it the exact one on
/// the SIMD targets that are not in use.
[[nodiscard]] std::vector<Engine> our_engines();

/// The name of the exact setting.
inline constexpr const char* certified = "cdcluster, certified";

} // namespace cd::bench
