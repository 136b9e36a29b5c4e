// Scenarios that are computed while earlier ones run: random poses of any number in little memory.
#pragma once

#include "common/job/pose_source.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace cd {

/// Computes a job's scenario of that index: a function of the index alone, called on any thread.
using ScenarioMaker = std::function<Scenario(std::uint64_t)>;

/// What `make_random_poses` computes for each index. The trees must outlive the maker.
[[nodiscard]] ScenarioMaker
random_scenarios(const RandomPoses& options, const ObbTree& a, const ObbTree& b);

/// Reads in ascending order are served from windows that threads of its own compute ahead, of which
/// a bounded number is kept; a single scenario is computed by the caller. `stopped` is asked some
/// times a second while a read waits. Errors: Interrupted.
[[nodiscard]] std::unique_ptr<PoseSource> make_computed_source(std::uint64_t count,
                                                               ScenarioMaker maker,
                                                               unsigned threads,
                                                               std::function<bool()> stopped);

} // namespace cd
