// Issues certificates to joining and renewing peers.
#pragma once

#include "master/identity/access.hpp"
#include "proto/channel/channel.hpp"

#include <memory>

namespace cd {

/// Serves a connection after the welcome: reads a Join or a Renew, answers, and ends.
[[nodiscard]] asio::awaitable<void> admit(std::shared_ptr<Channel> channel, Access access);

} // namespace cd
