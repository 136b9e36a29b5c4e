// Proves that a page is read whole, and that anything else than a page is an error that says what.
#include "proto/channel/http/http_get.hpp"

#include "proto/channel/http/http.hpp"
#include "tests/proto/loopback.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <thread>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Reads /page of a server that treats its one connection by `serve`, on a thread of its own.
Result<std::string> get_from(const std::function<void(asio::ip::tcp::socket)>& serve,
                             std::chrono::seconds timeout = std::chrono::seconds(60)) {
    asio::io_context context;
    asio::ip::tcp::acceptor acceptor = listen_anywhere(context.get_executor());
    const Endpoint here{"127.0.0.1", acceptor.local_endpoint().port()};
    std::thread server([&] {
        serve(acceptor.accept());
        context.run();
    });
    auto page = http_get({here, "/page"}, timeout);
    server.join();
    return page;
}

/// Makes a server that reads a request, writes this text and hangs up.
std::function<void(asio::ip::tcp::socket)> writes(const std::string& text) {
    return [text](asio::ip::tcp::socket socket) {
        std::array<char, 4096> request{};
        socket.read_some(asio::buffer(request));
        asio::write(socket, asio::buffer(text));
    };
}

TEST(HttpGet, APageOfOurServerComesWhole) {
    const std::string text(3'000'000, 'x');
    std::string asked;
    const auto page = get_from([&](asio::ip::tcp::socket socket) {
        serve_http(std::make_unique<Stream>(std::move(socket)),
                   [&](const HttpRequest& request, const HttpRespond& respond) {
                       asked = request.method + " " + request.target + " at " + request.host;
                       respond({200, text});
                   });
    });
    ASSERT_TRUE(page) << page.error().detail;
    EXPECT_EQ(page.value(), text);
    EXPECT_EQ(asked, "GET /page at 127.0.0.1");
}

TEST(HttpGet, AnotherStatusIsAnErrorWithTheServersReason) {
    const auto page = get_from([](asio::ip::tcp::socket socket) {
        serve_http(std::make_unique<Stream>(std::move(socket)),
                   [](const HttpRequest&, const HttpRespond& respond) {
                       respond({403, "a certificate is needed\n"});
                   });
    });
    ASSERT_FALSE(page);
    EXPECT_EQ(page.error().code, ErrorCode::Refused);
    EXPECT_EQ(page.error().detail, "it answers 403: a certificate is needed");
}

TEST(HttpGet, WhatIsNoPageIsAnError) {
    const auto broken = get_from(writes("220 mail.example ESMTP\r\n\r\n"));
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ErrorCode::BadFrame) << broken.error().detail;
    const auto cut = get_from(writes("HTTP/1.1 200 OK\r\nContent-Length: 100\r\n\r\nabc"));
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().code, ErrorCode::Disconnected);
    const auto large = get_from(writes("HTTP/1.1 200 OK\r\nContent-Length: 99999999999\r\n\r\n"));
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ErrorCode::TooLarge);
    const auto nothing = get_from(writes(""));
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.error().code, ErrorCode::Disconnected);
}

TEST(HttpGet, ASilentServerOrNoneIsAnError) {
    asio::io_context context;
    asio::ip::tcp::acceptor silent = listen_anywhere(context.get_executor());
    const Endpoint here{"127.0.0.1", silent.local_endpoint().port()};
    const auto unanswered = http_get({here, "/page"}, std::chrono::seconds(1));
    ASSERT_FALSE(unanswered);
    EXPECT_EQ(unanswered.error().code, ErrorCode::Timeout);
    silent.close();
    const auto refused = http_get({here, "/page"});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Disconnected);
    EXPECT_THAT(refused.error().detail, StartsWith("cannot connect to 127.0.0.1:"));
}

} // namespace
} // namespace cd::tests
