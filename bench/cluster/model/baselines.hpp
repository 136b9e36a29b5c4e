// Costs of other ways to distribute a job, from the same trace, with assumptions in favour of each.
#pragma once

#include "bench/cluster/model/workload.hpp"

#include <cstdint>
#include <span>

namespace cd::bench {

struct BaselineOutcome {
    double seconds = 0;
    std::uint64_t sent_bytes = 0;       ///< Block bytes sent by the master.
    std::uint64_t memory_bytes_max = 0; ///< Largest memory of one host.
};

/// Fixed, equal shares of the scenarios for each host, in order (Assarsson and Stenstroem). Hosts
/// fetch the blocks of their shares while they already compute, and share the master's link
/// equally.
[[nodiscard]] BaselineOutcome
static_split(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

/// The master sends the whole geometry to every host before it begins; then no host is ever idle.
/// Assumes that each host can hold it.
[[nodiscard]] BaselineOutcome
whole_everywhere(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

/// A bound for all strategies: each touched block leaves the master once, and no host is ever idle.
[[nodiscard]] BaselineOutcome
offline_optimum(const Workload& workload, std::span<const double> speeds, double bytes_per_second);

} // namespace cd::bench
