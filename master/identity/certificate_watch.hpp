// Ends connections whose certificate is no longer valid.
#pragma once

#include "master/identity/access.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <memory>

namespace cd {

/// Closes the channel when the peer's certificate expires or its holder is refused. The peer may
/// reconnect with another certificate. To stop watching, close the channel and cancel `pause`.
[[nodiscard]] asio::awaitable<void> watch_certificate(std::shared_ptr<Channel> channel,
                                                      Access access,
                                                      std::shared_ptr<asio::steady_timer> pause);

} // namespace cd
