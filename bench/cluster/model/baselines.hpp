// What other ways of giving out a job would take, counted over the same costs; each in its own
// favour.
#pragma once

#include "bench/cluster/model/workload.hpp"

#include <cstdint>
#include <span>

namespace cd::bench {

struct BaselineOutcome {
    double seconds = 0;
    std::uint64_t sent_bytes = 0;       ///< Blocks, by the master.
    std::uint64_t memory_bytes_max = 0; ///< At one host.
};

/// Equal shares of the scenarios for each host, in order and for good (Assarsson and Stenstroem).
/// Hosts fetch what their shares touch; all of it while they already compute, the master's link
/// being shared equally.
[[nodiscard]] BaselineOutcome
static_split(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

/// The whole geometry to every host, from the master, before a host begins; then no host is ever
/// idle. Figures for hosts that can hold it.
[[nodiscard]] BaselineOutcome
whole_everywhere(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

/// A bound for everybody: each block that is touched leaves the master once, and no host is ever
/// idle.
[[nodiscard]] BaselineOutcome
offline_optimum(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

} // namespace cd::bench
