// Makes answers to clients fit the size limit of a message.
#pragma once

#include "proto/codec/message.hpp"

namespace cd {

/// Returns the answer if it fits a message. Otherwise drops meshes from a ClusterStatus until it
/// fits, or returns a Failure saying that the answer is too large.
[[nodiscard]] Message fitting(Message answer);

} // namespace cd
