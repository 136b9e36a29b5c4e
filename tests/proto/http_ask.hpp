// Asks an HTTP server in another process, as a browser does.
#pragma once

#include "common/core/files/bytes.hpp"
#include "proto/channel/stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace cd::tests {

struct HttpReply {
    int status = 0; ///< 0: there was no answer.
    std::string head;
    std::string body;

    [[nodiscard]] std::span<const std::byte> bytes() const {
        return std::as_bytes(std::span(body));
    }
};

/// Splits an answer into its parts.
[[nodiscard]] inline HttpReply parse_reply(const std::string& text) {
    const std::size_t end = text.find("\r\n\r\n");
    if (!text.starts_with("HTTP/1.1 ") || end == std::string::npos) {
        return {};
    }
    return {std::stoi(text.substr(9, 3)), text.substr(0, end), text.substr(end + 4)};
}

[[nodiscard]] inline std::string request_text(const std::string& method,
                                              const std::string& target,
                                              const std::string& headers = "",
                                              const std::string& host = "127.0.0.1") {
    return method + " " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers + "\r\n";
}

/// Sends one request to a port on this machine, in TLS unless `tls` is null, and reads the answer.
[[nodiscard]] inline HttpReply
http_ask(std::uint16_t port, std::string request, std::shared_ptr<const Tls> tls = nullptr) {
    struct Asking {
        asio::io_context context;
        std::unique_ptr<Stream> stream;
        std::array<char, 65536> part{};
        std::string answer;

        void read() {
            stream->read_some(asio::buffer(part), [this](const auto& error, std::size_t bytes) {
                answer.append(part.data(), bytes);
                if (!error) {
                    read();
                }
            });
        }
        asio::awaitable<void> begin(std::shared_ptr<const Tls> with, const std::string& text) {
            if (with != nullptr) {
                const Status secured = co_await stream->secure(
                    std::move(with), TlsEnd::Connecting, std::chrono::seconds(60));
                EXPECT_TRUE(secured) << secured.error().detail;
            }
            stream->write({asio::buffer(text), asio::const_buffer()}, [](auto&&...) {});
            read();
        }
    };
    Asking asking;
    asio::ip::tcp::socket socket(asking.context);
    socket.connect({asio::ip::address_v4::loopback(), port});
    asking.stream = std::make_unique<Stream>(std::move(socket));
    asio::co_spawn(asking.context, asking.begin(std::move(tls), request), [](auto&&...) {});
    asking.context.run_for(std::chrono::seconds(60));
    return parse_reply(asking.answer);
}

} // namespace cd::tests
