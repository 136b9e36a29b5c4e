// The greeting on both sides of a new channel.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <memory>

namespace cd {

/// Sends a Hello and awaits the answer within the timeout. The channel then expects the messages of
/// the requested role. Errors: Refused with the peer's reason, and those of `receive`.
[[nodiscard]] asio::awaitable<Result<Welcome>>
greet(std::shared_ptr<Channel> channel,
      Hello hello,
      std::chrono::steady_clock::duration timeout = timing::connect_timeout);

/// Checks that the peer has this end's protocol version. Errors: Refused naming both versions.
[[nodiscard]] Status check_version(const Hello& hello);

/// Awaits the Hello of an accepted peer within `timing::connect_timeout`. The channel then expects
/// messages of the Hello's role, and the caller answers with a Welcome. After a wrong version or
/// message, sends a Failure and closes. Errors: Refused, BadFrame, and those of `receive`.
[[nodiscard]] asio::awaitable<Result<Hello>> accept_hello(std::shared_ptr<Channel> channel);

} // namespace cd
