// Issues certificates to peers that join with a token or renew their certificate.
#pragma once

#include "master/identity/access.hpp"
#include "proto/channel/channel.hpp"

#include <memory>

namespace cd {

/// Serves a connection after its Welcome: reads one Join or Renew, answers it, and closes.
[[nodiscard]] asio::awaitable<void> admit(std::shared_ptr<Channel> channel, Access access);

} // namespace cd
