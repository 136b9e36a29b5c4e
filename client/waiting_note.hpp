// Why a job on a master does not go on, in a line for people.
#pragma once

#include "proto/client_messages.hpp"

#include <string>

namespace cd {

struct WaitingNote {
    std::string text;          ///< Empty: it needs nothing.
    bool stands_still = false; ///< Nothing is done of the job until that changes.
};

/// The first that applies: the job is paused; no worker is here; workers are silent or lost.
/// `master` is the address that the user gave.
[[nodiscard]] WaitingNote
waiting_note(const JobStatus& job, const ClusterStatus& cluster, const std::string& master);

} // namespace cd
