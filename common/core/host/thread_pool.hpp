// A thread pool that its users share.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cd {

/// A fixed number of threads that run posted functions in the order of posting.
class ThreadPool {
  public:
    /// With 0 threads, starts one for each core that this process may use.
    explicit ThreadPool(unsigned threads = 0);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    /// Runs all posted functions, then joins the threads.
    ~ThreadPool();

    /// Queues a function, which a thread of the pool runs. The function must not throw.
    void post(std::function<void()> function);

    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(threads_.size()); }

  private:
    void work();

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> waiting_;
    bool stopping_ = false;
    std::vector<std::thread> threads_;
};

/// Calls `function(i)` once for each i in [0, count), on the pool's threads and the caller's.
/// Returns when all calls have. Must not be called from a function that runs on the same pool.
void parallel_for(ThreadPool& pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function);

/// Calls `function(i)` for each i in [0, count); on the caller's thread alone if `pool` is null.
void parallel_for(ThreadPool* pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function);

} // namespace cd
