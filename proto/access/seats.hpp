// Connection slots for peers that are not authenticated yet.
#pragma once

#include "proto/channel/asio.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace cd {

/// Limits simultaneous connections, and shares the slots fairly: a host may hold at most as many
/// slots as remain free. One host gets at most half of the slots; n greedy hosts get 1/(n+1) each,
/// and leave as many for a newcomer. Not thread-safe.
class Seats {
  public:
    /// A taken slot, released when the last copy is destroyed. A copy may outlive the `Seats`.
    using Seat = std::shared_ptr<const void>;

    explicit Seats(std::size_t seats_max);

    /// Takes a slot for a peer; null if none is available to the peer's host.
    [[nodiscard]] Seat take(const asio::ip::address& from);
    /// Takes a slot for the peer of a socket. If the peer has disconnected already, the slot counts
    /// only against the total.
    [[nodiscard]] Seat take(const asio::ip::tcp::socket& socket);
    [[nodiscard]] std::size_t taken() const { return state_->taken; }

  private:
    struct State {
        std::size_t seats_max = 0;
        std::size_t taken = 0;
        std::map<asio::ip::address, std::size_t> of_host; ///< Taken slots; keys are `host_of`.
    };
    std::shared_ptr<State> state_;
};

/// The host of an address: an IPv4 address in any notation, or the /64 network of an IPv6 address,
/// since a host can use any address in it.
[[nodiscard]] asio::ip::address host_of(const asio::ip::address& address);

/// The peer of a connection, as HOST:PORT, for logs.
[[nodiscard]] std::string peer_name(const asio::ip::tcp::socket& socket);

} // namespace cd
