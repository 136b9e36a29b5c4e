// A thread pool, and loops that run on it in parallel.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cd {

/// A fixed number of threads that start posted functions in the order of posting.
class ThreadPool {
  public:
    /// Starts `threads` threads; if 0, one for each core that this process may use.
    explicit ThreadPool(unsigned threads = 0);
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    /// Runs all posted functions, then joins the threads.
    ~ThreadPool();

    /// Queues a function for the pool's threads. The function must not throw.
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
/// Returns when all calls have returned. A function that runs on `pool` must not call this.
void parallel_for(ThreadPool& pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function);

/// Calls `parallel_for(*pool, ...)`, or if `pool` is null, runs the loop on the caller's thread.
void parallel_for(ThreadPool* pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function);

} // namespace cd
