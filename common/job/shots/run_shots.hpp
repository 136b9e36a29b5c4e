// Runs one scenario whose body B is a bundle of lines: which triangles each line meets, and where.
#pragma once

#include "common/job/run_scenario.hpp"

#include <span>

namespace cd {

/// Finds the hits under the given pairs of subtrees. Each triangle of B is a segment (p, q, q); it
/// meets the triangles of A that it is in contact with. Fills the result: contact if any line meets
/// A, else separate; `pair_count` is the number of hits, or of lines with a crossing if the query
/// asks for first hits. Fills `run.found` with the crossings if the query has maps.
///
/// `kept.search` has the scenario's poses. Returns false if `options.stop` ended the run.
[[nodiscard]] bool find_shots(KeptSearch& kept,
                              std::span<const SubtreePair> pairs,
                              const Scenario& scenario,
                              const Query& query,
                              const RunOptions& options,
                              ScenarioRun& run);

/// Returns whether `find_shots` needs the pairs and their corners, not only their number.
[[nodiscard]] bool needs_hits(const Query& query);

} // namespace cd
