// Answers to clients that may grow larger than a message.
#pragma once

#include "proto/codec/message.hpp"

namespace cd {

/// The answer if it fits a message. Otherwise a status with as many meshes as fit, or a Failure
/// that says that the answer is too large.
[[nodiscard]] Message fitting(Message answer);

} // namespace cd
