// Shared by the Google Benchmark programs: a thread's own time, and a checksum.
#pragma once

#include <cstdint>
#include <ctime>

namespace cd::bench {

/// Returns this thread's time: other processes on the host do not count.
[[nodiscard]] inline double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// FNV-1a over the results.
class Checksum {
  public:
    template <class Values>
    void add_all(const Values& values) {
        for (const auto value : values) {
            add(static_cast<std::uint64_t>(value));
        }
    }
    void add(std::uint64_t value) { sum_ = (sum_ ^ value) * 0x100000001b3u; }
    /// Returns the sum as a number that a double holds exactly.
    [[nodiscard]] double value() const { return static_cast<double>(sum_ >> 12); }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325u;
};

} // namespace cd::bench
