// A job over a fleet of bodies, scaled up from a trace.
#pragma once

#include "bench/cluster/model/workload.hpp"

#include <cstdint>

namespace cd::bench {

struct FleetOptions {
    std::uint32_t depth = 8; ///< Of each body's cut.
    /// The fixed body is as many copies of the trace's as have this many triangles. A copy's roots
    /// are its own.
    std::uint64_t triangles = 100'000'000;
    /// What the master gives out: so many neighbouring scenarios, which touch what one recorded
    /// scenario touches. The master analyses one of them.
    std::uint64_t together = 1000;
    std::uint64_t count = 0;           ///< Of these.
    std::uint64_t scenario_bytes = 16; ///< Of a scenario's result: counts, not pairs.
    std::uint64_t seed = 1;            ///< Of the copy and the recorded scenario of each.
};

/// Costs as measured. The trace has the depth.
[[nodiscard]] Workload make_fleet(const Trace& trace, const FleetOptions& options);

} // namespace cd::bench
