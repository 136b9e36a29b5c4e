#include "proto/messages/party.hpp"

#include "common/core/limits/wire.hpp"
#include "proto/messages/session_messages.hpp"

#include <array>

namespace cd {

namespace {

constexpr std::array<std::string_view, 9> party_names{"a stranger",
                                                      "a peer",
                                                      "a joiner",
                                                      "an observer",
                                                      "a client",
                                                      "a worker",
                                                      "a fetching worker",
                                                      "a giving worker",
                                                      "a master"};

} // namespace

Party party_of(Role role) {
    switch (role) {
    case Role::Worker:
        return Party::Worker;
    case Role::Client:
        return Party::Client;
    case Role::Peer:
        return Party::Peer;
    case Role::Joiner:
        break;
    }
    return Party::Joiner;
}

std::string_view to_text(Party party) {
    return party_names[static_cast<std::size_t>(party)];
}

std::size_t streams_max_of(Party party) {
    const bool is_small =
        party == Party::Stranger || party == Party::Joiner || party == Party::Observer;
    const bool is_known = party != Party::Anyone;
    return is_small   ? limits::streams_small_max
           : is_known ? limits::streams_of_lanes_max
                      : limits::streams_max;
}

} // namespace cd
