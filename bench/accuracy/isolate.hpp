// Runs work in its own process, so that a crash or a hang becomes a result.
#pragma once

#include "common/core/check.hpp"

#include <sys/mman.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>

namespace cd::bench {

enum class Ending { Done, Crashed, TimedOut };

[[nodiscard]] std::string_view to_text(Ending ending);

/// Runs `work` in a child process and waits for its end. The parent sees only what it writes into a
/// SharedArray. Only for a process with one thread.
[[nodiscard]] Ending run_isolated(std::chrono::seconds limit, const std::function<void()>& work);

/// Zeroed memory shared with children started later.
template <class T>
class SharedArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    explicit SharedArray(std::size_t size) : size_(size) {
        void* memory = ::mmap(nullptr,
                              bytes(),
                              PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_ANONYMOUS, // NOLINT(hicpp-signed-bitwise)
                              -1,
                              0);
        CD_CHECK(memory != MAP_FAILED);
        data_ = static_cast<T*>(memory);
    }
    SharedArray(const SharedArray&) = delete;
    SharedArray& operator=(const SharedArray&) = delete;
    ~SharedArray() { ::munmap(data_, bytes()); }

    [[nodiscard]] std::span<T> values() const { return {data_, size_}; }
    [[nodiscard]] T& operator[](std::size_t i) const { return data_[i]; }

  private:
    [[nodiscard]] std::size_t bytes() const { return (size_ + 1) * sizeof(T); }

    std::size_t size_;
    T* data_ = nullptr;
};

} // namespace cd::bench
