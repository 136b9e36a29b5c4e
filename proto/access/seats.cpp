#include "proto/access/seats.hpp"

#include <algorithm>

namespace cd {

asio::ip::address host_of(const asio::ip::address& address) {
    if (address.is_v4()) {
        return address;
    }
    const asio::ip::address_v6 v6 = address.to_v6();
    if (v6.is_v4_mapped()) {
        return asio::ip::make_address_v4(asio::ip::v4_mapped, v6);
    }
    auto bytes = v6.to_bytes();
    std::fill(bytes.begin() + bytes.size() / 2, bytes.end(), 0);
    return asio::ip::address_v6(bytes);
}

std::string peer_name(const asio::ip::tcp::socket& socket) {
    boost::system::error_code ignored;
    const auto end = socket.remote_endpoint(ignored);
    return end.address().to_string() + ":" + std::to_string(end.port());
}

Seats::Seats(std::size_t seats_max) : state_(std::make_shared<State>()) {
    state_->seats_max = seats_max;
}

Seats::Seat Seats::take(const asio::ip::address& from) {
    if (state_->taken >= state_->seats_max) {
        return nullptr;
    }
    const asio::ip::address host = host_of(from);
    std::size_t& held = state_->of_host[host];
    const bool is_known = !from.is_unspecified(); // Not `host`: the /64 of ::1 is ::.
    if (is_known && held >= state_->seats_max - state_->taken) {
        return nullptr; // The host holds slots, so its map entry is in use.
    }
    ++held;
    ++state_->taken;
    return {state_.get(), [state = state_, host](const void*) {
                --state->taken;
                const auto entry = state->of_host.find(host);
                if (--entry->second == 0) {
                    state->of_host.erase(entry);
                }
            }};
}

Seats::Seat Seats::take(const asio::ip::tcp::socket& socket) {
    boost::system::error_code gone;
    return take(socket.remote_endpoint(gone).address());
}

} // namespace cd
