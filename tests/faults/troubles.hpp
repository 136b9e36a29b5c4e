// Kinds of fault, and how often each took effect. Planned faults without effect do not count.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cd::tests {

enum class Trouble : std::uint8_t {
    // Faults of messages.
    Doubled,    ///< It arrived twice.
    Overtaken,  ///< A later message arrived first.
    Delayed,    ///< It took longer than any message without faults.
    Lost,       ///< It was lost with its connection; one end noticed later.
    Unwelcomed, ///< A worker's welcome was lost with its connection.
    Late,       ///< It arrived when its sender had begun to greet again.
    // Faults of workers.
    WorkerCutOff,  ///< A message from or to the worker had to wait.
    WorkerStopped, ///< A message or a thread's result had to wait for the stopped worker.
    WorkerSlowed,  ///< Its threads took at least twice as long for something.
    WorkerDrained, ///< The master received its notice of draining.
    WorkerKilled,
    WorkerGone,     ///< It was killed, and its peers are not notified.
    WorkerPoisoned, ///< A scenario killed it.
    WorkerMute,     ///< A message to the master vanished unnoticed.
    WorkerDeaf,     ///< A message from the master vanished unnoticed.
    WorkerApart,    ///< A message or connection between workers failed.
    CacheShrunk,    ///< It had to evict subtrees that no task needed.
    // Faults of the master.
    MasterCutOff, ///< A message from or to the master had to wait.
    MasterStopped,
    MasterKilled,
    PowerCut,
    UnsyncedLost,   ///< A power cut lost unsynced data.
    DiskFull,       ///< The disk refused a write.
    DiskUnreadable, ///< The disk refused a read that a running job needs.
    BlocksLost,     ///< A file of blocks was lost or damaged, and made again.
    count,
};

class Troubles {
  public:
    void add(Trouble trouble) { ++counts_[static_cast<std::size_t>(trouble)]; }
    [[nodiscard]] std::uint64_t of(Trouble trouble) const {
        return counts_[static_cast<std::size_t>(trouble)];
    }
    Troubles& operator+=(const Troubles& other);
    /// Lists each kind with its name, for people.
    [[nodiscard]] std::string text() const;

  private:
    std::array<std::uint64_t, static_cast<std::size_t>(Trouble::count)> counts_{};
};

[[nodiscard]] const char* to_text(Trouble trouble);

} // namespace cd::tests
