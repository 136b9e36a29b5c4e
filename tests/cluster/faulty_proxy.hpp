// A faulty network between two processes: it delays, cuts, swallows, damages, trickles and stalls.
#pragma once

#include "tests/cluster/delay_line.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>

namespace cd::tests {

enum class Weather {
    Fair,
    Delayed,   ///< Bytes arrive later, both ways, at any rate: 20 ms if nothing else is set.
    Paced,     ///< Carries 16 KiB in 20 ms, each way.
    Swallowed, ///< All bytes are read, none delivered, on new connections too (half open). A
               ///< connection that lost bytes so carries none any more, in any mode.
    Trickling, ///< Delivers some bytes per millisecond.
    Stalled,   ///< Reads nothing, so the sender's buffers fill.
};

/// Forwards connections on its own thread. All members are thread-safe.
class FaultyProxy {
  public:
    using Endpoint = asio::ip::tcp::endpoint;
    /// Returns the destination of an accepted connection. May set options of the onward socket.
    using Route =
        std::function<Endpoint(asio::ip::tcp::socket& accepted, asio::ip::tcp::socket& onward)>;

    /// Listens on a port of loopback that the system chooses, and forwards to another of them. If
    /// its address is not 127.0.0.1, workers pack results as between hosts.
    explicit FaultyProxy(std::uint16_t target, const char* listen = "127.0.0.1");
    FaultyProxy(const Endpoint& listen, Route route);
    FaultyProxy(const FaultyProxy&) = delete;
    FaultyProxy& operator=(const FaultyProxy&) = delete;
    ~FaultyProxy();

    /// Returns HOST:PORT.
    [[nodiscard]] std::string address() const;
    [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

    void set(Weather weather) { weather_.store(weather); }
    /// Sets how much later bytes arrive while the weather is `Delayed`, each way.
    void set_delay(std::chrono::milliseconds delay) { delay_.store(delay); }
    /// Ends all current connections; new ones are accepted.
    void cut() {
        cut_if([] { return true; });
    }
    /// Calls `is_cut` once for each connection, on the proxy's thread; ends it if that is true.
    void cut_if(std::function<bool()> is_cut);
    /// Flips one bit of the next bytes, towards the target or back.
    void damage(bool towards_target) {
        (towards_target ? damage_there_ : damage_back_).store(true);
    }
    /// Flips one bit of the first bytes (the greeting) of the next connection.
    void damage_greeting(bool towards_target) {
        (towards_target ? damage_greeting_there_ : damage_greeting_back_).store(true);
    }

    [[nodiscard]] std::uint64_t connections() const { return connections_.load(); }
    [[nodiscard]] std::uint64_t cuts() const { return cuts_.load(); }
    // Counts of faults so far, both directions together.
    [[nodiscard]] std::uint64_t damaged() const { return damaged_.load(); } ///< Flipped bits.
    /// Delayed and paced pieces.
    [[nodiscard]] std::uint64_t delayed() const { return delayed_.load(); }
    [[nodiscard]] std::uint64_t trickled() const { return trickled_.load(); } ///< Trickled pieces.
    [[nodiscard]] std::uint64_t swallowed() const {
        return swallowed_.load();
    }                                                                       ///< Swallowed bytes.
    [[nodiscard]] std::uint64_t stalled() const { return stalled_.load(); } ///< Stalled streams.

  private:
    struct Link {
        explicit Link(asio::ip::tcp::socket accepted)
            : client(std::move(accepted)), server(client.get_executor()) {}
        void close();
        asio::ip::tcp::socket client;
        asio::ip::tcp::socket server;
        bool damage_there = false; ///< Damage the next bytes to the target.
        bool damage_back = false;
        bool has_lost_bytes = false; ///< As TCP, deliver up to some byte, then nothing.
    };

    asio::awaitable<void> accept();
    asio::awaitable<void> connect(std::shared_ptr<Link> link);
    asio::awaitable<void>
    read(std::shared_ptr<Link> link, bool towards_target, std::shared_ptr<DelayLine> line);
    asio::awaitable<void>
    write(std::shared_ptr<Link> link, bool towards_target, std::shared_ptr<DelayLine> line);
    asio::awaitable<void> stand_still(const Link& link);
    asio::awaitable<void> deliver(asio::ip::tcp::socket& to, std::string piece);
    static asio::awaitable<void> pause(std::chrono::milliseconds time);

    asio::io_context context_{1};
    asio::ip::tcp::acceptor acceptor_;
    Route route_;
    std::list<std::weak_ptr<Link>> links_;
    std::atomic<Weather> weather_ = Weather::Fair;
    std::atomic<std::chrono::milliseconds> delay_{std::chrono::milliseconds(20)};
    std::atomic<bool> damage_there_ = false;
    std::atomic<bool> damage_back_ = false;
    std::atomic<bool> damage_greeting_there_ = false;
    std::atomic<bool> damage_greeting_back_ = false;
    std::atomic<std::uint64_t> connections_ = 0;
    std::atomic<std::uint64_t> cuts_ = 0;
    std::atomic<std::uint64_t> damaged_ = 0;
    std::atomic<std::uint64_t> delayed_ = 0;
    std::atomic<std::uint64_t> trickled_ = 0;
    std::atomic<std::uint64_t> swallowed_ = 0;
    std::atomic<std::uint64_t> stalled_ = 0;
    std::thread thread_; ///< Last member: it uses all others.
};

} // namespace cd::tests
