// Connecting a TCP socket.
#pragma once

#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>

namespace cd {

/// Connects to the first address that answers; each attempt has the full timeout. Errors:
/// Disconnected naming host and port.
[[nodiscard]] asio::awaitable<Result<asio::ip::tcp::socket>>
open_socket(Endpoint endpoint, std::chrono::seconds timeout);

} // namespace cd
