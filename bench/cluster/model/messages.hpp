// What travels in the simulated cluster, and how many bytes that is on the real wire.
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
    bool is_first = false; ///< Of the worker: the trees are named to it before.
};
struct BlocksSent {
    std::vector<BlockId> blocks;
};
/// To be fetched from another worker.
struct FetchDirected {
    WorkerId source;
    std::vector<BlockId> blocks; ///< Of one tree.
};
/// Scenarios that wait in the worker's buffer will need these.
struct Hinted {
    std::vector<BlockId> blocks; ///< Of one tree, ascending.
};
/// To give back of the task what has not begun of these.
struct AskedBack {
    TaskId task;
    std::vector<std::uint64_t> scenarios;
};
/// Another worker has answered it.
struct CalledOff {
    TaskId task;
    std::uint64_t scenario = 0;
};
struct Ended {};

// ---- Worker to worker -----------------------------------------------------------------------

/// Answered by BlocksSent.
struct PeerAsked {
    WorkerId asker;
    std::vector<BlockId> blocks; ///< Of one tree.
};
using ToWorker = std::
    variant<BatchSent, BlocksSent, FetchDirected, PeerAsked, Hinted, AskedBack, CalledOff, Ended>;

// ---- Worker to master -----------------------------------------------------------------------

struct BlocksWanted {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// The worker has these no longer.
struct BlocksEvicted {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// The source did not have these.
struct PeerFailed {
    WorkerId worker;
    WorkerId source;
    std::vector<BlockId> blocks; ///< Of one tree, ascending.
};
struct ResultsSent {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios;
    double compute_seconds = 0; ///< That the worker's threads took for them.
    bool ends_task = false;
    bool is_checked = false; ///< At the master: what stands in it has been unpacked and checked.
};
/// All that was given back of the task.
struct GaveBack {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Ascending.
};
/// From now on the worker has these.
struct BlocksHeld {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
/// Not on the wire: another core of the master's host has analysed it.
struct Analysed {
    std::uint64_t scenario = 0;
};
using ToMaster = std::
    variant<BlocksWanted, BlocksHeld, BlocksEvicted, PeerFailed, ResultsSent, GaveBack, Analysed>;

/// By the codec of the real messages, their frames included; records, poses and blocks as the
/// workload says.
[[nodiscard]] std::uint64_t bytes_of(const ToWorker& message, const Workload& workload);
[[nodiscard]] std::uint64_t bytes_of(const ToMaster& message, const Workload& workload);

} // namespace cd::bench
