// Simulates a machine with little memory.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace cd::tests {

/// Limits this process to so many bytes beyond its current use.
class MemoryBound {
  public:
    explicit MemoryBound(rlim_t bytes) {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        getrlimit(RLIMIT_AS, &before_);
        const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
        const rlimit bounded{pages * page + bytes, before_.rlim_max};
        setrlimit(RLIMIT_AS, &bounded);
    }
    ~MemoryBound() { setrlimit(RLIMIT_AS, &before_); }
    MemoryBound(const MemoryBound&) = delete;
    MemoryBound& operator=(const MemoryBound&) = delete;

  private:
    rlimit before_{};
};

} // namespace cd::tests
