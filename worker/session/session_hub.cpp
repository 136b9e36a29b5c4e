#include "worker/session/session_hub.hpp"

#include <utility>

namespace cd {

void SessionHub::settle_soon() {
    if (std::exchange(settling_, true)) {
        return;
    }
    asio::post(home(), [weak = weak_from_this()] {
        if (const auto hub = weak.lock()) {
            hub->settling_ = false;
            hub->settle();
        }
    });
}

void SessionHub::run_on_thread(std::function<Executor::Continuation()> job) {
    executor_.submit([weak = weak_from_this(), over = over_, job = std::move(job)] {
        if (over->load()) {
            return Executor::Continuation([] {});
        }
        return Executor::Continuation([weak, over, then = job()] {
            const auto hub = weak.lock(); // Keeps the parts that `then` uses.
            if (hub != nullptr && !over->load()) {
                then();
            }
        });
    });
}

} // namespace cd
