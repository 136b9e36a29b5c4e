// Runs foreign code that may crash, hang or exhaust memory, in a child process.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <chrono>
#include <cstdint>
#include <functional>

namespace cd {

struct ChildLimits {
    std::uint64_t memory_bytes = 0; ///< Beyond what is mapped at the fork; no limit in sanitizers.
    std::chrono::seconds processor_time{0};
    std::chrono::seconds real_time{0}; ///< Also bounds a child that only waits.
};

enum class ChildEnd : std::uint8_t { Answered, Crashed, OutOfMemory, OutOfTime, Stopped };

struct ChildAnswer {
    ChildEnd end = ChildEnd::Crashed;
    Bytes bytes; ///< The result of `work` if `end` is Answered.
};

/// Calls `work` in a fork of this process and returns when the child has ended, for whatever
/// reason. The child is cut off from the terminal, dies with this process, and has default signal
/// handlers. The result is Stopped if a signal ends the child, or once `is_stopped` returns true.
///
/// The child has one thread, so `work` must not take a lock that another thread may have held at
/// the fork. The C library's own locks (memory, streams) are free after a fork.
///
/// Errors: Io when no process or pipe can be created.
[[nodiscard]] Result<ChildAnswer> call_in_child(const std::function<Bytes()>& work,
                                                const ChildLimits& limits,
                                                const StopCheck& is_stopped);

} // namespace cd
