// Answers to clients that may grow larger than a message.
#pragma once

#include "proto/message.hpp"

namespace cd {

/// What is sent for it: the same, where it fits a message. Of a status as many meshes as fit; in
/// place of anything else, a Failure that says so.
[[nodiscard]] Message fitting(Message answer);

} // namespace cd
