// Runs work on thread pools, and passes the outcome to the owner's thread.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "master/base/event_loop.hpp"

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace cd {

/// The parts of the coordinator use other threads only through this class. All members but `post`
/// run on the owner's thread, which runs the event loop.
class Background {
  public:
    /// `after_each` is called on the owner's thread after each `done` or posted function. The loop
    /// must outlive the pools, and must not run after this object is destroyed.
    Background(EventLoop& loop, Pool& compute, Pool& blocking, std::function<void()> after_each)
        : loop_(loop), compute_(compute), blocking_(blocking), after_each_(std::move(after_each)) {}
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// The pool for work that needs neither the disk nor another pool.
    [[nodiscard]] Pool& compute_pool() { return compute_; }
    /// Runs `work` on the compute pool, then `done` with its outcome on the owner's thread.
    template <class Work, class Done>
    void compute(Work work, Done done) {
        run(compute_, std::move(work), std::move(done));
    }
    /// Like `compute`, but on the blocking pool: for work that waits for the disk, or takes long.
    template <class Work, class Done>
    void block(Work work, Done done) {
        run(blocking_, std::move(work), std::move(done));
    }
    /// Calls `function` on the owner's thread; may be called on any thread.
    template <class Function>
    void post(Function function) {
        loop_.post([this, function = std::move(function)]() mutable {
            function();
            after_each_();
        });
    }

  private:
    template <class Work, class Done>
    void run(Pool& pool, Work work, Done done) {
        auto step = std::make_shared<std::pair<Work, Done>>(std::move(work), std::move(done));
        // The pool may outlive this object. Its thread keeps no reference to `step`, so that `done`
        // is destroyed on the owner's thread.
        pool.post([this, &loop = loop_, step = std::move(step)]() mutable {
            using Outcome = std::invoke_result_t<Work&>;
            auto outcome = std::make_shared<Outcome>(step->first());
            loop.post([this, step = std::move(step), outcome = std::move(outcome)] {
                step->second(std::move(*outcome));
                after_each_();
            });
        });
    }

    EventLoop& loop_;
    Pool& compute_;
    Pool& blocking_;
    std::function<void()> after_each_;
};

} // namespace cd
