// Kinds of trouble, and how often each of them took effect: what only was to happen is not counted.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cd::tests {

enum class Trouble : std::uint8_t {
    // Of messages.
    Doubled,    ///< It came a second time.
    Overtaken,  ///< A later one came before it.
    Delayed,    ///< It came longer after its sending than any without trouble.
    Lost,       ///< With its connection, which one of its ends took for sound until then.
    Unwelcomed, ///< The same, of the welcome of a worker.
    Late,       ///< It came when its sender had begun to greet again.
    // Of workers.
    WorkerCutOff,  ///< A message to or from it had to wait for the end of that.
    WorkerStopped, ///< Something came to it, or was done by its threads, that it could not take up.
    WorkerSlowed,  ///< Its threads took at least twice as long for something.
    WorkerDrained, ///< The master heard it say so.
    WorkerKilled,
    WorkerGone,     ///< The same, and its peers are not told.
    WorkerPoisoned, ///< A scenario took it down.
    WorkerMute,     ///< A message of it to the master vanished, and nothing said so;
    WorkerDeaf,     ///< one of the master to it;
    WorkerApart,    ///< one between it and another worker, or they could not connect.
    CacheShrunk,    ///< It had to let go of subtrees that nothing there waited for.
    // Of the master.
    MasterCutOff, ///< From everybody: as for a worker.
    MasterStopped,
    MasterKilled,
    PowerCut,
    UnsyncedLost,   ///< The disk was another one after a power cut.
    DiskFull,       ///< It refused to write,
    DiskUnreadable, ///< or to read what a job needs that runs.
    BlocksLost,     ///< A file of blocks was gone or damaged, and made again.
    count,
};

class Troubles {
  public:
    void add(Trouble trouble) { ++counts_[static_cast<std::size_t>(trouble)]; }
    [[nodiscard]] std::uint64_t of(Trouble trouble) const {
        return counts_[static_cast<std::size_t>(trouble)];
    }
    Troubles& operator+=(const Troubles& other);
    /// For people: each with its name.
    [[nodiscard]] std::string text() const;

  private:
    std::array<std::uint64_t, static_cast<std::size_t>(Trouble::count)> counts_{};
};

[[nodiscard]] const char* to_text(Trouble trouble);

} // namespace cd::tests
