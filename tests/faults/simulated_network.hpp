// The network of a simulated cluster: messages take time and suffer faults on the way.
#pragma once

#include "proto/channel/network.hpp"

namespace cd::tests {

/// Connects the hosts of the current world.
[[nodiscard]] Network& simulated_network();

} // namespace cd::tests
