// How much of a speed-up comes from matching, from bytes, from the order of the scenarios and from
// peers: each is switched off by itself.
#pragma once

#include "bench/cluster/paper/experiments.hpp"

namespace cd::bench {

/// Runs all scenarios at the scene's depth with the paper's strategies, which choose a client for
/// each scenario or scenarios for each client, with and without peers and the longest scenarios
/// first; and with `earliest-finish` and without each of its parts. Runs those without switches,
/// and ours, again with bytes that cost nothing. Appends rows to the file.
void attribute(CsvFile& csv,
               const ExperimentOptions& experiment,
               const Setting& setting,
               const Scene& scene);

/// Columns of the file.
[[nodiscard]] std::vector<std::string> attribution_columns();

} // namespace cd::bench
