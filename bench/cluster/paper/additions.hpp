// The later parts of `earliest-finish`, each switched off and on.
#pragma once

#include "bench/cluster/paper/experiments.hpp"

#include <vector>

namespace cd::bench {

/// Measures the gain of hints, and of recalls and speculative copies at the end, for jobs matched
/// by time: with slow cores as in the table, some of a tenth of the speed, and links of a tenth of
/// the rate, at the scene's depth. Writes additions.csv.
void compare_additions(const ExperimentOptions& experiment,
                       const std::vector<Setting>& settings,
                       const Scene& scene);

} // namespace cd::bench
