// Fits answers to clients into the size limit of a message.
#pragma once

#include "proto/codec/message.hpp"

namespace cd {

/// Returns the answer if it fits a message. Otherwise returns a status with as many meshes as fit,
/// or a Failure saying that the answer is too large.
[[nodiscard]] Message fitting(Message answer);

} // namespace cd
