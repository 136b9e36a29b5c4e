// Runs foreign code that may crash, hang or take all memory, in a process of its own.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/result.hpp"
#include "common/core/stop_check.hpp"

#include <chrono>
#include <cstdint>
#include <functional>

namespace cd {

struct ChildLimits {
    std::uint64_t memory_bytes = 0; ///< Beside what this process has; unbounded under sanitizers.
    std::chrono::seconds processor_time{0};
    std::chrono::seconds real_time{0}; ///< For a child that waits for something.
};

enum class ChildEnd : std::uint8_t { Answered, Crashed, OutOfMemory, OutOfTime, Stopped };

struct ChildAnswer {
    ChildEnd end = ChildEnd::Crashed;
    Bytes bytes; ///< What `work` returned, if it answered.
};

/// Calls `work` in a fork of this process, and returns when that has ended, whatever it did. The
/// child reads and writes nothing of the terminal, ends with this process, and by the signals that
/// end one; a signal to it alone, and `is_stopped`, end the call with Stopped.
///
/// The child goes on with one thread. So `work` may take no lock that another thread of this
/// process could hold: the C library's own (memory, streams) are free after a fork, and locks of
/// ours have to be left alone.
///
/// Errors: Io when the system has no room for another process.
[[nodiscard]] Result<ChildAnswer> call_in_child(const std::function<Bytes()>& work,
                                                const ChildLimits& limits,
                                                const StopCheck& is_stopped);

} // namespace cd
