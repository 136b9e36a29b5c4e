// Reads one page of an HTTP server.
#pragma once

#include "common/core/result.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/channel/channel.hpp"
#include "proto/channel/tls.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace cd {

/// A page, for example /metrics at a master's HTTP port.
struct HttpPage {
    Endpoint server;
    std::string target;
    std::shared_ptr<const Tls> tls = nullptr; ///< Null: plain HTTP.
};

/// Reads the page by GET, on this thread. Connecting, securing and reading each have the timeout.
/// Errors: Disconnected if the server does not answer or hangs up; Refused for another status than
/// 200, with the server's text, or by TLS; Timeout; BadFrame if the answer is not HTTP; TooLarge.
[[nodiscard]] Result<std::string> http_get(const HttpPage& page,
                                           std::chrono::seconds timeout = timing::connect_timeout);

} // namespace cd
