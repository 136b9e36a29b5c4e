// Pools of threads that their users share.
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

/// Runs posted functions, which must not throw, in the order of posting.
class Pool {
  public:
    Pool() = default;
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    virtual ~Pool() = default;

    /// Queues a function. Any thread.
    virtual void post(std::function<void()> function) = 0;
    /// Number of functions that may run at once; at least 1.
    [[nodiscard]] virtual unsigned size() const = 0;
};

/// A fixed number of threads.
class ThreadPool final : public Pool {
  public:
    /// With 0 threads, starts one for each core that this process may use.
    explicit ThreadPool(unsigned threads = 0);
    /// Runs all posted functions, then joins the threads.
    ~ThreadPool() override;

    void post(std::function<void()> function) override;
    [[nodiscard]] unsigned size() const override { return static_cast<unsigned>(threads_.size()); }

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
void parallel_for(Pool& pool, std::size_t count, const std::function<void(std::size_t)>& function);

/// Calls `function(i)` for each i in [0, count); on the caller's thread alone if `pool` is null.
void parallel_for(Pool* pool, std::size_t count, const std::function<void(std::size_t)>& function);

} // namespace cd
