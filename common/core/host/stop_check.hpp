// Lets long computations stop when their answer is no longer needed.
#pragma once

#include "common/core/result.hpp"

#include <functional>

namespace cd {

/// The working thread polls it, so it is cheap. Once true, it stays true. Empty means never.
using StopCheck = std::function<bool()>;

/// Returns the error of stopped work.
[[nodiscard]] inline Error interrupted() {
    return {ErrorCode::Interrupted, "interrupted"};
}

} // namespace cd
