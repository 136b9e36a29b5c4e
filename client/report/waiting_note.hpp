// A line for people with the reason why a job on a master makes no progress.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <string>

namespace cd {

struct WaitingNote {
    std::string text;          ///< Empty if the job is not waiting.
    bool stands_still = false; ///< No scenario runs while the reason lasts.
};

/// Returns a note with the first reason that applies, or an empty note: the job is paused; no
/// worker is connected; workers are silent or lost. `master` is the address that the user gave.
[[nodiscard]] WaitingNote
waiting_note(const JobStatus& job, const ClusterStatus& cluster, const std::string& master);

} // namespace cd
