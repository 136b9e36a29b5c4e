// The address of a program, and what it may be used for without TLS.
#pragma once

#include "common/core/result.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Host and port as written by a user: "127.0.0.1:7600", "[::1]:7600", "host:7600".
struct Endpoint {
    std::string host;
    std::uint16_t port = 0;
};

/// Parses HOST:PORT. Errors: BadInput naming the expected form.
[[nodiscard]] Result<Endpoint> parse_endpoint(const std::string& text);
/// True for 127.0.0.0/8, ::1 and "localhost".
[[nodiscard]] bool is_loopback(const Endpoint& endpoint);

/// How a program is about to use an endpoint.
struct Exposure {
    bool secured = false;   ///< Uses TLS.
    bool insecure = false;  ///< --insecure was given.
    bool listening = false; ///< False: connecting.
};
/// Forbids plain TCP beyond loopback, unless `insecure` is set, which logs a warning at any log
/// level instead. Errors: Refused, naming how to get TLS, and --insecure.
[[nodiscard]] Status check_exposure(const Endpoint& endpoint, const Exposure& exposure);

} // namespace cd
