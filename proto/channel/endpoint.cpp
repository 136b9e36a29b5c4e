#include "proto/channel/endpoint.hpp"

#include "common/core/host/log.hpp"
#include "proto/channel/asio.hpp"

#include <charconv>

namespace cd {
namespace {

Error endpoint_error(const std::string& text) {
    return {ErrorCode::BadInput,
            "'" + text +
                "' is no endpoint: expected HOST:PORT, such as 127.0.0.1:7600 or [::1]:7600"};
}

std::string to_text(const Endpoint& endpoint) {
    const bool is_v6 = endpoint.host.find(':') != std::string::npos;
    return (is_v6 ? "[" + endpoint.host + "]" : endpoint.host) + ":" +
           std::to_string(endpoint.port);
}

bool is_host(const std::string& text, bool in_brackets) {
    if (text.empty() || text.size() > 253) {
        return false;
    }
    const std::string_view allowed = in_brackets ? "0123456789abcdefABCDEF:.%"
                                                 : "0123456789abcdefghijklmnopqrstuvwxyz"
                                                   "ABCDEFGHIJKLMNOPQRSTUVWXYZ.-_";
    return text.find_first_not_of(allowed) == std::string::npos;
}

} // namespace

Result<Endpoint> parse_endpoint(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) {
        return endpoint_error(text);
    }
    std::string host = text.substr(0, colon);
    const bool in_brackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (in_brackets) {
        host = host.substr(1, host.size() - 2);
    }
    if (!is_host(host, in_brackets)) {
        return endpoint_error(text);
    }
    std::uint16_t port = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, port);
    if (error != std::errc() || rest != end) {
        return endpoint_error(text);
    }
    return Endpoint{std::move(host), port};
}

bool is_loopback(const Endpoint& endpoint) {
    boost::system::error_code error;
    const auto address = asio::ip::make_address(endpoint.host, error);
    return error ? endpoint.host == "localhost" : address.is_loopback();
}

Status check_exposure(const Endpoint& endpoint, const Exposure& exposure) {
    if (exposure.secured || is_loopback(endpoint)) {
        return Done{};
    }
    const std::string what =
        (exposure.listening ? "listening on " : "connecting to ") + to_text(endpoint);
    if (!exposure.insecure) {
        return Error{ErrorCode::Refused,
                     what + " leaves this machine without encryption or authentication; " +
                         (exposure.listening ? "make an identity with `cdmaster init`"
                                             : "join the cluster with a token (`join`)") +
                         ", or give --insecure on a network that you trust"};
    }
    warn_always("insecure: " + what + " without encryption or authentication");
    return Done{};
}

} // namespace cd
