// Ends connections whose certificate is no longer valid.
#pragma once

#include "master/identity/access.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <memory>

namespace cd {

/// Ends the connection when its holder's certificate expires or the holder is refused. The peer may
/// reconnect with another certificate. Returns when the channel is closed and `pause` cancelled.
[[nodiscard]] asio::awaitable<void> watch_certificate(std::shared_ptr<Channel> channel,
                                                      Access access,
                                                      std::shared_ptr<asio::steady_timer> pause);

} // namespace cd
