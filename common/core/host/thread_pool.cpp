#include "common/core/host/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <latch>

namespace cd {

ThreadPool::ThreadPool(unsigned threads) {
    const unsigned count =
        threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    threads_.reserve(count);
    for (unsigned i = 0; i < count; ++i) {
        threads_.emplace_back([this] { work(); });
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

void ThreadPool::post(std::function<void()> function) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.push_back(std::move(function));
    }
    changed_.notify_one();
}

void ThreadPool::work() {
    for (;;) {
        std::function<void()> function;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
            if (waiting_.empty()) {
                return;
            }
            function = std::move(waiting_.front());
            waiting_.pop_front();
        }
        function();
    }
}

void parallel_for(ThreadPool& pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function) {
    std::atomic<std::size_t> next{0};
    const auto take_turns = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            function(i);
        }
    };
    // The caller works too, so a pool of n threads contributes n - 1 helpers.
    const std::size_t helpers = std::min<std::size_t>(pool.size() - 1, count == 0 ? 0 : count - 1);
    std::latch finished(static_cast<std::ptrdiff_t>(helpers));
    for (std::size_t i = 0; i < helpers; ++i) {
        pool.post([&] {
            take_turns();
            finished.count_down();
        });
    }
    take_turns();
    finished.wait();
}

void parallel_for(ThreadPool* pool,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function) {
    if (pool != nullptr) {
        parallel_for(*pool, count, function);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        function(i);
    }
}

} // namespace cd
