// The parties of a connection, and the messages that each may send.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cd {

enum class Role : std::uint8_t;

/// What is known about the other end of a connection.
enum class Party : std::uint8_t {
    Stranger, ///< It has not greeted yet.
    Anyone,   ///< It has greeted, and its role was not checked.
    Joiner,
    Observer, ///< A client that may only read the cluster's state.
    Client,
    Worker,
    Peer,  ///< A worker that fetches blocks from another one.
    Giver, ///< A worker that serves blocks to another one.
    Master,
};

/// The party that sends a Hello with this role.
[[nodiscard]] Party party_of(Role role);
[[nodiscard]] std::string_view to_text(Party party);

/// The largest payload of this type from this party, bytes; 0: the party may not send it.
[[nodiscard]] std::uint64_t payload_bytes_max_from(Party party, std::uint16_t type);
/// The number of incomplete messages that a party may have.
[[nodiscard]] std::size_t streams_max_of(Party party);

} // namespace cd
