// Simulates a machine with little memory.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

namespace cd::tests {

/// Limits this process to so many bytes beyond its current use. Under sanitizers, whose own memory
/// would count, there is no limit.
class MemoryBound {
  public:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    static constexpr bool is_enforced = false;
#else
    static constexpr bool is_enforced = true;
#endif

    explicit MemoryBound(rlim_t bytes) {
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        getrlimit(RLIMIT_AS, &before_);
        const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
        const rlimit bounded{pages * page + bytes, before_.rlim_max};
        if (is_enforced) {
            setrlimit(RLIMIT_AS, &bounded);
        }
    }
    ~MemoryBound() {
        setrlimit(RLIMIT_AS, &before_);
    }
    MemoryBound(const MemoryBound&) = delete;
    MemoryBound& operator=(const MemoryBound&) = delete;

  private:
    rlimit before_{};
};

} // namespace cd::tests
