// Why a job on a master does not go on, in a line for people.
#pragma once

#include "proto/client_messages.hpp"

#include <string>

namespace cd {

/// The first that applies: the job is paused; no worker is here; workers are silent or lost. Empty
/// where the job needs nothing. `master` is the address that the user gave.
[[nodiscard]] std::string
waiting_note(const JobStatus& job, const ClusterStatus& cluster, const std::string& master);

} // namespace cd
