// What travels in the simulated cluster, and how many bytes that is on the real wire.
#pragma once

#include "bench/cluster/workload.hpp"
#include "common/core/id.hpp"
#include "proto/message.hpp"

#include <cstdint>
#include <variant>
#include <vector>

namespace cd::bench {

// ---- Master to worker -----------------------------------------------------------------------

struct BatchSent {
    TaskId task;
    std::vector<std::uint64_t> scenarios;
    bool with_tops = false; ///< The worker's first: the trees are named to it before.
};
struct BlocksSent {
    std::vector<BlockId> blocks;
};
struct Ended {};
using ToWorker = std::variant<BatchSent, BlocksSent, Ended>;

// ---- Worker to master -----------------------------------------------------------------------

struct BlocksWanted {
    WorkerId worker;
    std::vector<BlockId> blocks; ///< Ascending.
};
struct ResultsSent {
    WorkerId worker;
    TaskId task;
    std::vector<std::uint64_t> scenarios;
    bool ends_task = false;
};
/// Not on the wire: another core of the master's host has analysed it.
struct Analysed {
    std::uint64_t scenario = 0;
};
using ToMaster = std::variant<BlocksWanted, ResultsSent, Analysed>;

/// By the codec of the real messages, their frames included; records, poses and blocks as the
/// workload says.
[[nodiscard]] std::uint64_t bytes_of(const ToWorker& message, const Workload& workload);
[[nodiscard]] std::uint64_t bytes_of(const ToMaster& message, const Workload& workload);

} // namespace cd::bench
