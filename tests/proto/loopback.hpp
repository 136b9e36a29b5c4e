// Two ends of a connection on this machine, for tests of protocols.
#pragma once

#include "proto/channel/channel.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/endpoint.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

namespace cd::tests {

/// Longer than any test takes, even under a sanitizer; a hanging test fails after it.
inline constexpr std::chrono::seconds patience{60};

/// Both ends of a connection before there are channels.
struct SocketEnds {
    asio::ip::tcp::socket left;
    asio::ip::tcp::socket right;
};

inline asio::awaitable<SocketEnds> connect_sockets() {
    const auto executor = co_await asio::this_coro::executor;
    const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
    asio::ip::tcp::acceptor acceptor(executor, any_port);
    asio::ip::tcp::socket left(executor);
    co_await left.async_connect(acceptor.local_endpoint(), asio::use_awaitable);
    asio::ip::tcp::socket right = co_await acceptor.async_accept(asio::use_awaitable);
    co_return SocketEnds{std::move(left), std::move(right)};
}

struct Ends {
    std::shared_ptr<Channel> left;
    std::shared_ptr<Channel> right;
};

/// Connects two channels over a port chosen by the system.
inline asio::awaitable<Ends> connect_ends() {
    const auto executor = co_await asio::this_coro::executor;
    const asio::ip::tcp::endpoint any_port(asio::ip::address_v4::loopback(), 0);
    asio::ip::tcp::acceptor acceptor(executor, any_port);
    Endpoint endpoint{"127.0.0.1", acceptor.local_endpoint().port()};
    Result<std::shared_ptr<Channel>> left = co_await connect(endpoint);
    asio::ip::tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
    Ends ends;
    ends.left = std::move(left.value());
    ends.right = Channel::make(std::make_unique<Stream>(std::move(socket)));
    co_return ends;
}

/// Connects two channels that have greeted each other.
inline asio::awaitable<Ends> connect_greeted_ends() {
    Ends ends = co_await connect_ends();
    Hello hello;
    Welcome welcome;
    ends.left->send(hello);
    ends.right->send(welcome);
    Result<Message> first = co_await ends.right->receive(patience);
    EXPECT_TRUE(first);
    Result<Message> second = co_await ends.left->receive(patience);
    EXPECT_TRUE(second);
    co_return ends;
}

/// Runs the conversation, and everything it spawns, to the end.
inline void run_conversation(const std::function<asio::awaitable<void>()>& conversation) {
    asio::io_context context;
    bool ended = false;
    asio::co_spawn(context, conversation(), [&](const std::exception_ptr& thrown) {
        ended = true;
        if (thrown) {
            std::rethrow_exception(thrown);
        }
    });
    context.run_for(patience);
    EXPECT_TRUE(ended);
    EXPECT_TRUE(context.stopped()) << "something is still under way";
}

} // namespace cd::tests
