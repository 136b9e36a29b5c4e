// A hash that identifies a job's poses by their numbers, however the poses are packed.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <span>

namespace cd {

/// Computes SHA-256 over all scenarios in submitted order: for each the forms of A's and B's poses
/// (u8 each, as in `pack_scenarios`), then the doubles of both, little-endian, -0 as 0.
class PosesHash {
  public:
    void add(std::span<const Scenario> scenarios);
    /// Returns the hash. Nothing may be added afterwards.
    [[nodiscard]] Sha256 finish();

  private:
    Sha256Stream stream_;
};

/// Returns SHA-256 of a grid's description (`encode_grid`), which stands for its poses.
[[nodiscard]] Sha256 hash_of(const Grid& grid);

/// Returns the hash of all poses of a source; for a grid, the hash of its description. Errors:
/// those of `PoseSource::read`; Interrupted.
[[nodiscard]] Result<Sha256> hash_of(PoseSource& poses, const StopCheck& stop = {});

} // namespace cd
