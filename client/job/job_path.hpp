// Makes the poses of a job with a curve, with motions, or with poses inserted between its own.
#pragma once

#include "client/curves/row_curve.hpp"
#include "client/job/prepared_job.hpp"
#include "client/spec/poses_spec.hpp"
#include "common/core/result.hpp"

#include <vector>

namespace cd {

/// Makes the keys of a curve the poses of a job, with their times as labels, and says how far they
/// are from it. Errors: as `keys_along`.
[[nodiscard]] Status make_keys(PreparedJob& job, const CurveSpec& curve);

/// Replaces the poses of a job, which are those of a file's rows, by keys along the curves on which
/// their rates lead, as `make_keys` does. A job that has neither [motion] nor `max_step` stays as
/// it is, and says so. Rows without a time are at 0, 1, 2, and so on. Errors: as `keys_between`,
/// with the file; BadInput for a chord without rates.
[[nodiscard]] Status make_row_keys(PreparedJob& job, const std::vector<PoseRates>& rates);

/// Replaces the poses of a job by the motions from each to the next, or inserts poses between them,
/// if the job has [motion] or `max_step`. Errors: as `make_motions` and `make_steps`, with the
/// place; BadInput for a chord that does not cover the rounding of the keys.
[[nodiscard]] Status make_path(PreparedJob& job);

} // namespace cd
