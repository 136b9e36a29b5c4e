// How one who wants a certificate gets it.
#pragma once

#include "master/identity/access.hpp"
#include "proto/channel/channel.hpp"

#include <memory>

namespace cd {

/// The conversation after the welcome: a Join or a Renew, its answer, and the end.
[[nodiscard]] asio::awaitable<void> admit(std::shared_ptr<Channel> channel, Access access);

} // namespace cd
