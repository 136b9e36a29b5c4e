// Scenarios that are computed while earlier ones run: random poses of any number in little memory.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace cd {

/// Computes a job's scenario of that index: a function of the index alone, called on any thread.
using ScenarioMaker = std::function<Scenario(std::uint64_t)>;

/// Makes the scenarios of `make_random_poses` one by one. The trees must outlive the maker.
[[nodiscard]] ScenarioMaker
random_scenarios(const RandomPoses& options, const ObbTree& a, const ObbTree& b);

/// A source that computes windows of scenarios ahead, on threads of its own, and keeps a bounded
/// number of them: fast for reads in ascending order. A read of one scenario computes it itself.
/// One thread may read at a time. `stopped` is asked some times a second while a read waits.
/// Errors of reads: Interrupted.
[[nodiscard]] std::unique_ptr<PoseSource>
make_computed_source(std::uint64_t count, ScenarioMaker maker, unsigned threads, StopCheck stopped);

} // namespace cd
