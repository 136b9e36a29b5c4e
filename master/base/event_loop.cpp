#include "master/base/event_loop.hpp"

#include <utility>

namespace cd {

void AsioLoop::after(Duration delay, std::function<void()> function) {
    if (is_closed_) {
        return;
    }
    const auto timer = std::make_shared<asio::steady_timer>(executor_, delay);
    running_->insert(timer);
    timer->async_wait([timer, running = running_, function = std::move(function)](
                          const boost::system::error_code& /*why*/) {
        if (running->erase(timer) != 0) {
            function();
        }
    });
}

void AsioLoop::close() {
    is_closed_ = true;
    for (const Timer& timer : std::exchange(*running_, {})) {
        timer->cancel();
    }
}

} // namespace cd
