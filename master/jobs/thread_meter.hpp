// Processor time of one thread for each item that it processes.
#pragma once

#include "master/dispatch/worker_pace.hpp"

#include <cstdint>
#include <functional>
#include <utility>

namespace cd {

/// Processor time of the calling thread, s.
[[nodiscard]] double thread_cpu_seconds();

/// Learns the time for an item from the thread's whole time, so it includes all that the thread
/// does besides.
class ThreadMeter {
  public:
    /// `cpu_seconds` returns the thread's processor time, s.
    explicit ThreadMeter(std::function<double()> cpu_seconds)
        : cpu_seconds_(std::move(cpu_seconds)), since_(cpu_seconds_()) {}

    /// Counts items that the thread has processed.
    void count(std::uint64_t items);
    /// Seconds for an item; 0 until it is known.
    [[nodiscard]] double seconds_each() const { return each_.value_or(0); }

  private:
    std::function<double()> cpu_seconds_;
    LearnedRate each_;
    std::uint64_t items_ = 0; ///< Items since `since_`.
    double since_ = 0;
};

} // namespace cd
