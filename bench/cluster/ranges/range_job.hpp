// Large jobs that go out in ranges: workers find the colliding roots themselves.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "bench/cluster/trace/trace.hpp"

#include <cstdint>

namespace cd::bench {

struct RangeJobOptions {
    std::uint32_t depth = 6; ///< The trace must have it.
    std::uint64_t count = 0;
    double scenario_seconds = 1e-4;           ///< Mean time of a scenario on a worker's thread.
    std::uint64_t geometry_bytes = 6'800'000; ///< Both bodies on the wire.
    /// Neighbouring positions that touch what one recorded scenario touches.
    std::uint64_t together = 64;
    std::uint64_t result_bytes = 16; ///< Of each scenario: level count.
    std::uint64_t seed = 1;
};

/// Takes the recorded scenarios' touched roots and ratios of their times, and the ratios of the
/// blocks' sizes and of the times to open them.
[[nodiscard]] Workload make_range_job(const Trace& trace, const RangeJobOptions& options);

/// Lower limits on the seconds of the job.
struct RangeLimits {
    double compute = 0;  ///< All threads work all the time.
    double geometry = 0; ///< Each host receives all blocks over its link, which peers pass on.
    double master = 0;   ///< The master sees each result.

    [[nodiscard]] double largest() const;
};

[[nodiscard]] RangeLimits limits_of(const Workload& workload,
                                    std::uint64_t hosts,
                                    std::uint32_t threads,
                                    double bytes_per_second,
                                    double result_seconds);

} // namespace cd::bench
