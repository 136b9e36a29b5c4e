// A network between two processes that does what real ones do: it delays, cuts, swallows, damages,
// trickles and stalls.
#pragma once

#include "proto/channel/asio.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <thread>

namespace cd::tests {

enum class Weather {
    Fair,
    Delayed,   ///< Each piece comes 20 ms later, both ways.
    Swallowed, ///< All is taken and nothing comes out: half-open connections, new ones included. A
               ///< connection that has lost bytes so carries none any more, in any weather.
    Trickling, ///< Some bytes a millisecond.
    Stalled,   ///< Nothing is taken any more: the sender's buffers fill.
};

/// Carries connections on loopback to one port. On a thread of its own; all members may be called
/// at any time.
class FaultyProxy {
  public:
    explicit FaultyProxy(std::uint16_t target);
    FaultyProxy(const FaultyProxy&) = delete;
    FaultyProxy& operator=(const FaultyProxy&) = delete;
    ~FaultyProxy();

    /// HOST:PORT
    [[nodiscard]] std::string address() const;
    [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

    void set(Weather weather) { weather_.store(weather); }
    /// All connections of now end; new ones are welcome.
    void cut();
    /// One bit of one of the next bytes, towards the target or back.
    void damage(bool towards_target) {
        (towards_target ? damage_there_ : damage_back_).store(true);
    }
    /// The same, of what is said first on the next connection: a greeting.
    void damage_greeting(bool towards_target) {
        (towards_target ? damage_greeting_there_ : damage_greeting_back_).store(true);
    }

    [[nodiscard]] std::uint64_t connections() const { return connections_.load(); }
    // What has been done to the bytes so far, both ways together:
    [[nodiscard]] std::uint64_t damaged() const { return damaged_.load(); }     ///< Bits flipped.
    [[nodiscard]] std::uint64_t delayed() const { return delayed_.load(); }     ///< Pieces held up.
    [[nodiscard]] std::uint64_t trickled() const { return trickled_.load(); }   ///< Small pieces.
    [[nodiscard]] std::uint64_t swallowed() const { return swallowed_.load(); } ///< Bytes.
    [[nodiscard]] std::uint64_t stalled() const { return stalled_.load(); }     ///< Streams halted.

  private:
    struct Link {
        explicit Link(asio::ip::tcp::socket accepted)
            : client(std::move(accepted)), server(client.get_executor()) {}
        void close();
        asio::ip::tcp::socket client;
        asio::ip::tcp::socket server;
        bool damage_there = false; ///< Its next bytes.
        bool damage_back = false;
        bool has_lost_bytes = false; ///< TCP delivers all up to some byte, and then nothing.
    };

    asio::awaitable<void> accept();
    asio::awaitable<void> connect(std::shared_ptr<Link> link);
    asio::awaitable<void> carry(std::shared_ptr<Link> link, bool towards_target);
    asio::awaitable<void> stand_still(const Link& link);
    asio::awaitable<void> deliver(asio::ip::tcp::socket& to, std::string piece);
    static asio::awaitable<void> pause(std::chrono::milliseconds time);

    asio::io_context context_{1};
    asio::ip::tcp::acceptor acceptor_;
    asio::ip::tcp::endpoint target_;
    std::list<std::weak_ptr<Link>> links_;
    std::atomic<Weather> weather_ = Weather::Fair;
    std::atomic<bool> damage_there_ = false;
    std::atomic<bool> damage_back_ = false;
    std::atomic<bool> damage_greeting_there_ = false;
    std::atomic<bool> damage_greeting_back_ = false;
    std::atomic<std::uint64_t> connections_ = 0;
    std::atomic<std::uint64_t> damaged_ = 0;
    std::atomic<std::uint64_t> delayed_ = 0;
    std::atomic<std::uint64_t> trickled_ = 0;
    std::atomic<std::uint64_t> swallowed_ = 0;
    std::atomic<std::uint64_t> stalled_ = 0;
    std::thread thread_; ///< Last: it uses the members above.
};

} // namespace cd::tests
