#include "tests/cluster/faulty_proxy.hpp"

#include "proto/channel/channel.hpp"

#include <fcntl.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t trickle_bytes = 16;
constexpr std::size_t paced_bytes = 16384;
constexpr std::chrono::milliseconds pace{20};
constexpr std::size_t delayed_bytes_max = 64U << 20U; ///< 1 Gb/s fill a tenth of it in 50 ms.

/// Sets close-on-exec: a child process of the test would keep the connection open.
template <class Socket>
void keep_from_children(Socket& socket) {
    (void)::fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
}

} // namespace

FaultyProxy::FaultyProxy(std::uint16_t target, const char* listen)
    : FaultyProxy({asio::ip::make_address(listen), 0}, [target](tcp::socket&, tcp::socket&) {
          return Endpoint(asio::ip::address_v4::loopback(), target);
      }) {}

FaultyProxy::FaultyProxy(const Endpoint& listen, Route route)
    : acceptor_(context_, listen), route_(std::move(route)) {
    keep_from_children(acceptor_);
    spawn(context_.get_executor(), "proxy", accept());
    thread_ = std::thread([this] { context_.run(); });
}

FaultyProxy::~FaultyProxy() {
    context_.stop();
    thread_.join();
}

std::string FaultyProxy::address() const {
    const asio::ip::address listens = acceptor_.local_endpoint().address();
    return (listens.is_unspecified() ? "127.0.0.1" : listens.to_string()) + ":" +
           std::to_string(port());
}

void FaultyProxy::cut_if(std::function<bool()> is_cut) {
    asio::post(context_, [this, is_cut = std::move(is_cut)] {
        links_.remove_if([&](const std::weak_ptr<Link>& weak) {
            const auto link = weak.lock();
            if (link && is_cut()) {
                link->close();
                ++cuts_;
                return true;
            }
            return !link;
        });
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
    link->server.open(tcp::v4(), error);
    keep_from_children(link->server);
    const Endpoint target = route_(link->client, link->server);
    co_await link->server.async_connect(target, asio::redirect_error(asio::use_awaitable, error));
    if (error) {
        link->close();
        co_return;
    }
    link->client.set_option(tcp::no_delay(true), error);
    link->server.set_option(tcp::no_delay(true), error);
    for (const bool towards_target : {true, false}) {
        auto line = std::make_shared<DelayLine>(context_.get_executor());
        spawn(context_.get_executor(), "bytes read", read(link, towards_target, line));
        spawn(context_.get_executor(), "bytes written", write(link, towards_target, line));
    }
}

asio::awaitable<void> FaultyProxy::read(std::shared_ptr<Link> link,
                                        bool towards_target,
                                        std::shared_ptr<DelayLine> line) {
    tcp::socket& from = towards_target ? link->client : link->server;
    tcp::socket& to = towards_target ? link->server : link->client;
    std::atomic<bool>& damage = towards_target ? damage_there_ : damage_back_;
    bool& damage_greeting = towards_target ? link->damage_there : link->damage_back;
    std::vector<char> buffer(65536);
    while (from.is_open() && to.is_open()) {
        if (weather_.load() == Weather::Stalled) {
            ++stalled_;
            co_await stand_still(*link);
            continue;
        }
        error_code error;
        const bool is_paced = weather_.load() == Weather::Paced;
        const std::size_t bytes = co_await from.async_read_some(
            asio::buffer(buffer.data(), is_paced ? paced_bytes : buffer.size()),
            asio::redirect_error(asio::use_awaitable, error));
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
        const Weather weather = weather_.load();
        const auto delay = weather == Weather::Delayed ? delay_.load()
                           : weather == Weather::Paced ? pace
                                                       : std::chrono::milliseconds(0);
        delayed_ += delay.count() > 0 ? 1 : 0;
        co_await line->put(
            std::move(piece), delay, weather == Weather::Delayed ? delayed_bytes_max : 0);
    }
    line->close();
}

asio::awaitable<void> FaultyProxy::write(std::shared_ptr<Link> link,
                                         bool towards_target,
                                         std::shared_ptr<DelayLine> line) {
    tcp::socket& to = towards_target ? link->server : link->client;
    while (to.is_open()) {
        std::optional<std::string> piece = co_await line->take();
        if (!piece) {
            break;
        }
        co_await deliver(to, std::move(*piece));
    }
    line->close();
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
