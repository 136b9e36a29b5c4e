// Messages that change a job which the master has.
#pragma once

#include "common/core/id.hpp"

#include <cstdint>

namespace cd {

/// Gives a job that has not ended another priority. Answered by JobStatus once the disk has it.
/// Errors: NotFound; BadInput; Refused for a job that has ended.
struct SetPriority {
    JobId job;
    std::int32_t priority = 0; ///< As in Submit.
};

} // namespace cd
