#include "tests/cluster/faulty_proxy.hpp"

#include "proto/channel/channel.hpp"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cd::tests {
namespace {

using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::milliseconds delay{20};
constexpr std::size_t trickle_bytes = 16;

/// Sets close-on-exec: a child process of the test would keep the connection open.
template <class Socket>
void keep_from_children(Socket& socket) {
    (void)::fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
}

} // namespace

FaultyProxy::FaultyProxy(std::uint16_t target)
    : acceptor_(context_, tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
      target_(asio::ip::address_v4::loopback(), target) {
    keep_from_children(acceptor_);
    spawn(context_.get_executor(), "proxy", accept());
    thread_ = std::thread([this] { context_.run(); });
}

FaultyProxy::~FaultyProxy() {
    context_.stop();
    thread_.join();
}

std::string FaultyProxy::address() const {
    return "127.0.0.1:" + std::to_string(port());
}

void FaultyProxy::cut() {
    asio::post(context_, [this] {
        for (const auto& weak : links_) {
            if (const auto link = weak.lock()) {
                link->close();
            }
        }
        links_.clear();
    });
}

void FaultyProxy::Link::close() {
    error_code ignored;
    client.close(ignored);
    server.close(ignored);
}

asio::awaitable<void> FaultyProxy::accept() {
    for (;;) {
        auto link = std::make_shared<Link>(co_await acceptor_.async_accept(asio::use_awaitable));
        keep_from_children(link->client);
        link->damage_there = damage_greeting_there_.exchange(false);
        link->damage_back = damage_greeting_back_.exchange(false);
        ++connections_;
        links_.push_back(link);
        spawn(context_.get_executor(), "proxied connection", connect(std::move(link)));
    }
}

asio::awaitable<void> FaultyProxy::connect(std::shared_ptr<Link> link) {
    error_code error;
    link->server.open(target_.protocol(), error);
    keep_from_children(link->server);
    co_await link->server.async_connect(target_, asio::redirect_error(asio::use_awaitable, error));
    if (error) {
        link->close();
        co_return;
    }
    link->client.set_option(tcp::no_delay(true), error);
    link->server.set_option(tcp::no_delay(true), error);
    spawn(context_.get_executor(), "proxied bytes", carry(link, true));
    spawn(context_.get_executor(), "proxied bytes", carry(link, false));
}

asio::awaitable<void> FaultyProxy::carry(std::shared_ptr<Link> link, bool towards_target) {
    tcp::socket& from = towards_target ? link->client : link->server;
    tcp::socket& to = towards_target ? link->server : link->client;
    std::atomic<bool>& damage = towards_target ? damage_there_ : damage_back_;
    bool& damage_greeting = towards_target ? link->damage_there : link->damage_back;
    std::array<char, 16384> buffer{};
    while (from.is_open() && to.is_open()) {
        if (weather_.load() == Weather::Stalled) {
            ++stalled_;
            co_await stand_still(*link);
            continue;
        }
        error_code error;
        const std::size_t bytes = co_await from.async_read_some(
            asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, error));
        if (error) {
            break;
        }
        link->has_lost_bytes |= weather_.load() == Weather::Swallowed;
        if (link->has_lost_bytes) {
            swallowed_ += bytes;
            continue;
        }
        std::string piece(buffer.data(), bytes);
        if (std::exchange(damage_greeting, false) || damage.exchange(false)) {
            piece[bytes / 2] = static_cast<char>(piece[bytes / 2] ^ 0x10);
            ++damaged_;
        }
        if (weather_.load() == Weather::Delayed) {
            ++delayed_;
            co_await pause(delay);
        }
        co_await deliver(to, std::move(piece));
    }
    link->close();
}

asio::awaitable<void> FaultyProxy::stand_still(const Link& link) {
    while (weather_.load() == Weather::Stalled && link.client.is_open() && link.server.is_open()) {
        co_await pause(std::chrono::milliseconds(1));
    }
}

asio::awaitable<void> FaultyProxy::deliver(tcp::socket& to, std::string piece) {
    std::size_t sent = 0;
    while (sent < piece.size() && to.is_open()) {
        const bool trickles = weather_.load() == Weather::Trickling;
        const std::size_t bytes =
            trickles ? std::min(trickle_bytes, piece.size() - sent) : piece.size() - sent;
        error_code error;
        co_await asio::async_write(to,
                                   asio::buffer(piece.data() + sent, bytes),
                                   asio::redirect_error(asio::use_awaitable, error));
        if (error) {
            co_return;
        }
        sent += bytes;
        if (trickles) {
            ++trickled_;
            co_await pause(std::chrono::milliseconds(1));
        }
    }
}

asio::awaitable<void> FaultyProxy::pause(std::chrono::milliseconds time) {
    asio::steady_timer timer(co_await asio::this_coro::executor, time);
    error_code ignored;
    co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
}

} // namespace cd::tests
