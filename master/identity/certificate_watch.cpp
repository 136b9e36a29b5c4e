#include "master/identity/certificate_watch.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/master.hpp"
#include "master/identity/identity.hpp"

#include <algorithm>

namespace cd {

asio::awaitable<void> watch_certificate(std::shared_ptr<Channel> channel,
                                        Access access,
                                        std::shared_ptr<asio::steady_timer> pause) {
    const auto& holder = access.holder();
    while (holder && channel->is_open()) {
        if (const Status allowed = access.check_holder(); !allowed) {
            log_warning(
                "session ended: peer={} reason=\"{}\"", channel->peer(), allowed.error().detail);
            channel->close();
            co_return;
        }
        // Checks repeatedly, because the clock and the list of refused names may change at any
        // time.
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            holder->until - access.identity()->now());
        pause->expires_after(
            std::clamp<std::chrono::milliseconds>(left + std::chrono::milliseconds(1),
                                                  std::chrono::milliseconds(1),
                                                  timing::holder_check_period));
        boost::system::error_code ignored;
        co_await pause->async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

} // namespace cd
