// Lets long computations stop when their answer is no longer needed.
#pragma once

#include "common/core/result.hpp"

#include <functional>

namespace cd {

/// Returns true once the work has to stop, and from then on. The working thread polls the function,
/// which must be cheap. An empty function never stops the work.
using StopCheck = std::function<bool()>;

/// Returns the error of work that a StopCheck has stopped.
[[nodiscard]] inline Error interrupted() {
    return {ErrorCode::Interrupted, "interrupted"};
}

} // namespace cd
