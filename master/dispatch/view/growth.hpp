// Estimates how much sooner all running jobs would end with more workers.
#pragma once

#include "proto/messages/client_messages.hpp"

#include <cstdint>

namespace cd {

struct DispatchParts;

/// The present workers that take work, and one more worker like them.
struct WorkersNow {
    double workers = 0;
    double threads = 0;
    /// Threads of one more worker, in units of the present workers' average thread. It has the
    /// median power.
    double threads_more = 0;
    /// Time in which one more worker would receive as many blocks as a present one holds, s.
    double fetch_seconds = 0;
};

[[nodiscard]] WorkersNow workers_now(const DispatchParts& parts);

/// Work left of all running jobs. Times are seconds of one thread.
struct WorkLeft {
    double scenarios = 0;      ///< Scenarios that workers have yet to answer.
    double worker_seconds = 0; ///< Their time on threads of workers.
    double tail_seconds = 0;   ///< Time for which the last work keeps some of the threads busy.
    double pool_seconds = 0;   ///< Analysis on the master's pool, divided by its threads.
    double master_seconds = 0; ///< Time of the master's own thread.
};

/// Estimates the time left with so many more workers, s. The slowest counts: the workers, the
/// master's analysis, or the master's thread. New workers compute nothing until they have their
/// blocks, which they fetch from each other.
[[nodiscard]] double
seconds_left(const WorkersNow& workers, const WorkLeft& work, std::uint32_t more);

/// There must be workers and work left.
[[nodiscard]] Growth estimate_growth(const WorkersNow& workers, const WorkLeft& work);

} // namespace cd
