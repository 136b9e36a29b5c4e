// Computes random scenarios while earlier scenarios run: any number of poses in bounded memory.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/poses/random_poses.hpp"

#include <cstdint>
#include <memory>

namespace cd {

/// Makes a source that computes windows of scenarios ahead, on `threads` threads of its own, and
/// keeps a bounded number of windows. Reads in ascending order are fast. A read of one scenario
/// computes it directly. One thread may read at a time. A waiting read polls `stopped` several
/// times a second. Errors of reads: Interrupted.
[[nodiscard]] std::unique_ptr<PoseSource>
make_computed_source(std::uint64_t count, ScenarioMaker maker, unsigned threads, StopCheck stopped);

} // namespace cd
