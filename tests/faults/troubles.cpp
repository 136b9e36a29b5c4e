#include "tests/faults/troubles.hpp"

namespace cd::tests {

const char* to_text(Trouble trouble) {
    switch (trouble) {
    case Trouble::Doubled:
        return "doubled";
    case Trouble::Overtaken:
        return "overtaken";
    case Trouble::Delayed:
        return "delayed";
    case Trouble::Lost:
        return "lost";
    case Trouble::Unwelcomed:
        return "unwelcomed";
    case Trouble::Late:
        return "late";
    case Trouble::WorkerCutOff:
        return "worker_cut_off";
    case Trouble::WorkerStopped:
        return "worker_stopped";
    case Trouble::WorkerSlowed:
        return "worker_slowed";
    case Trouble::WorkerDrained:
        return "worker_drained";
    case Trouble::WorkerKilled:
        return "worker_killed";
    case Trouble::WorkerGone:
        return "worker_gone";
    case Trouble::WorkerPoisoned:
        return "worker_poisoned";
    case Trouble::WorkerMute:
        return "worker_mute";
    case Trouble::WorkerDeaf:
        return "worker_deaf";
    case Trouble::WorkerApart:
        return "worker_apart";
    case Trouble::CacheShrunk:
        return "cache_shrunk";
    case Trouble::MasterCutOff:
        return "master_cut_off";
    case Trouble::MasterStopped:
        return "master_stopped";
    case Trouble::MasterKilled:
        return "master_killed";
    case Trouble::PowerCut:
        return "power_cut";
    case Trouble::UnsyncedLost:
        return "unsynced_lost";
    case Trouble::DiskFull:
        return "disk_full";
    case Trouble::DiskUnreadable:
        return "disk_unreadable";
    case Trouble::BlocksLost:
        return "blocks_lost";
    case Trouble::count:
        break;
    }
    return "";
}

Troubles& Troubles::operator+=(const Troubles& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        counts_[i] += other.counts_[i];
    }
    return *this;
}

std::string Troubles::text() const {
    std::string text;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        text += std::string(text.empty() ? "" : " ") + to_text(static_cast<Trouble>(i)) + "=" +
                std::to_string(counts_[i]);
    }
    return text;
}

} // namespace cd::tests
