// Messages of the simulated cluster, and their sizes on the real wire.
#pragma once

#include "bench/cluster/model/workload.hpp"
#include "common/core/id.hpp"
#include "proto/codec/message.hpp"

#include <cstdint>
#include <variant>
#include <vector>

namespace cd::bench {

// ---- Master to worker -----------------------------------------------------------------------

struct BatchSent {
    TaskId task;
    std::vector<std::uint64_t> scenarios;
    bool is_first = false; ///< First to this worker: its trees are named to it before.
};
struct BlocksSent {
    std::vector<BlockId> blocks;
};
/// Blocks to fetch from another worker.
struct FetchDirected {
    WorkerId source;
    std::vector<BlockId> blocks; ///< Blocks of one tree.
};
/// Blocks that scenarios in the worker's buffer will need.
struct Hinted {
    std::vector<BlockId> blocks; ///< Blocks of one tree, ascending.
};
/// Recalls those scenarios of the task that have not begun.
struct AskedBack {
    TaskId task;
    std::vector<std::uint64_t> scenarios;
};
/// Another worker has answered the scenario.
struct CalledOff {
    TaskId task;
    std::uint64_t scenario = 0;
};
struct Ended {};

// ---- Worker to worker -----------------------------------------------------------------------

/// Requests blocks; the source answers with BlocksSent.
struct PeerAsked {
    WorkerId asker;
    std::vector<BlockId> blocks; ///< Blocks of one tree.
};
using ToWorker = std::
    variant<BatchSent, BlocksSent, FetchDirected, PeerAsked, Hinted, AskedBack, CalledOff, Ended>;

// ---- Worker to master -----------------------------------------------------------------------

struct BlocksWanted {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// The worker has evicted these blocks.
struct BlocksEvicted {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// The source did not have these blocks.
struct PeerFailed {
    WorkerId worker;
    WorkerId source;
    std::vector<BlockId> blocks; ///< Blocks of one tree, ascending.
};
struct ResultsSent {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios;
    double compute_seconds = 0; ///< Time of the worker's threads for these results.
    bool ends_task = false;
    bool is_checked = false; ///< At the master: the content has been unpacked and checked.
};
/// All returned scenarios of the task.
struct GaveBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Ascending.
};
/// The worker now holds these blocks.
struct BlocksHeld {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// Not on the wire: another core of the master's host has analysed the scenario.
struct Analysed {
    std::uint64_t scenario = 0;
};
using ToMaster = std::
    variant<BlocksWanted, BlocksHeld, BlocksEvicted, PeerFailed, ResultsSent, GaveBack, Analysed>;

/// Returns the size by the codec of the real messages, with frames; records, poses and blocks take
/// the workload's sizes.
[[nodiscard]] std::uint64_t bytes_of(const ToWorker& message, const Workload& workload);
[[nodiscard]] std::uint64_t bytes_of(const ToMaster& message, const Workload& workload);

} // namespace cd::bench
