// How long work learns that nobody waits for its answer any more.
#pragma once

#include "common/core/result.hpp"

#include <functional>

namespace cd {

/// Asked now and then, on the thread that works; cheap. Once it is true, it stays so. Empty: never.
using StopCheck = std::function<bool()>;

/// The error with which stopped work ends.
[[nodiscard]] inline Error interrupted() {
    return {ErrorCode::Interrupted, "interrupted"};
}

} // namespace cd
