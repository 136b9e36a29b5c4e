// A job over a fleet of bodies, scaled up from a trace.
#pragma once

#include "bench/cluster/model/workload.hpp"

#include <cstdint>

namespace cd::bench {

struct FleetOptions {
    std::uint32_t depth = 8; ///< Depth of each body's cut.
    /// The fixed body consists of copies of the trace's, with this many triangles in all. Each copy
    /// has its own roots.
    std::uint64_t triangles = 100'000'000;
    /// Size of a group of neighbouring scenarios, which the master hands out as one. A group
    /// touches what one recorded scenario touches, and the master analyses one of its scenarios.
    std::uint64_t together = 1000;
    std::uint64_t count = 0;           ///< Number of groups.
    std::uint64_t scenario_bytes = 16; ///< Bytes of a scenario's result: counts, not pairs.
    std::uint64_t seed = 1; ///< Seed for the copy and the recorded scenario of each group.
};

/// Uses measured costs. The trace must have the depth.
[[nodiscard]] Workload make_fleet(const Trace& trace, const FleetOptions& options);

} // namespace cd::bench
