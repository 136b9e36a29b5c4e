// How long the journal's commits take.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace cd {

/// Counts commits by their duration. Any thread may use it.
class CommitTimes {
  public:
    /// Upper bounds of the buckets, seconds. One more bucket has no bound.
    static constexpr std::array<double, 9> bounds{
        0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0};

    struct Counts {
        std::array<std::uint64_t, bounds.size() + 1> commits{}; ///< By bucket.
        double seconds = 0;                                     ///< Sum of all durations.
    };

    void add(std::chrono::duration<double> time) {
        std::size_t bucket = 0;
        while (bucket < bounds.size() && time.count() > bounds[bucket]) {
            ++bucket;
        }
        const std::lock_guard lock(mutex_);
        ++counts_.commits[bucket];
        counts_.seconds += time.count();
    }

    [[nodiscard]] Counts counts() const {
        const std::lock_guard lock(mutex_);
        return counts_;
    }

  private:
    mutable std::mutex mutex_;
    Counts counts_;
};

} // namespace cd
