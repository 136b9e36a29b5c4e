// A hash that names a job's poses. It depends on their numbers, not on how they are packed.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <span>

namespace cd {

/// SHA-256 over each scenario in submitted order: the form of A and the form of B (u8 each, as in
/// `pack_scenarios`), then their doubles, little-endian, -0 as 0.
class PosesHash {
  public:
    void add(std::span<const Scenario> scenarios);
    /// Returns the hash. Nothing may be added afterwards.
    [[nodiscard]] Sha256 finish();

  private:
    Sha256Stream stream_;
};

/// Returns SHA-256 of a grid's description (`encode_grid`), which is the hash of its poses.
[[nodiscard]] Sha256 hash_of(const Grid& grid);

/// Returns the hash of all poses of a source; if they are a grid, the grid's. Errors: those of
/// reading; Interrupted.
[[nodiscard]] Result<Sha256> hash_of(PoseSource& poses, const StopCheck& stop = {});

} // namespace cd
