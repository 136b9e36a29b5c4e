// Checks the chord of curves against the rounding of their keys.
#pragma once

#include "client/spec/job_file.hpp"
#include "common/core/result.hpp"

namespace cd {

/// Refuses a chord that does not also cover the rounding of the keys, which moves two bodies by up
/// to `moved` against each other. Errors: BadInput, naming the chord's line.
[[nodiscard]] Status check_chord(const JobSpec& spec, double moved);

} // namespace cd
