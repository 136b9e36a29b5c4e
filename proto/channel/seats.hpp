// Where those wait of whom nobody knows anything yet.
#pragma once

#include "proto/channel/asio.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace cd {

/// So many connections at a time, of which no host takes all: one may hold as many as are left
/// free. So a host alone gets half of them, n that want all get the n+1-th part each, and whoever
/// comes after them finds as many free. One thread.
class Seats {
  public:
    /// Taken while anything shares it; it may outlive the seats.
    using Seat = std::shared_ptr<const void>;

    explicit Seats(std::size_t seats_max);

    /// Null where there is none for it.
    [[nodiscard]] Seat take(const asio::ip::address& from);
    /// By its other end. Of one that has gone already nothing but the whole number counts.
    [[nodiscard]] Seat take(const asio::ip::tcp::socket& socket);
    [[nodiscard]] std::size_t taken() const { return state_->taken; }

  private:
    struct State {
        std::size_t seats_max = 0;
        std::size_t taken = 0;
        std::map<asio::ip::address, std::size_t> of_host;
    };
    std::shared_ptr<State> state_;
};

/// Whom an address belongs to: an IPv4 address stands for itself, however it is written, and an
/// IPv6 address for its network of 64 bits, in which a host has as many as it likes.
[[nodiscard]] asio::ip::address host_of(const asio::ip::address& address);

/// The other end of a connection for logs: HOST:PORT.
[[nodiscard]] std::string peer_name(const asio::ip::tcp::socket& socket);

} // namespace cd
