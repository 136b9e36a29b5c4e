// The parties of a connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cd {

enum class Role : std::uint8_t;

/// The other end of a connection, as far as it is known.
enum class Party : std::uint8_t {
    Stranger, ///< Has not greeted yet.
    Anyone,   ///< Has greeted, but its role was not checked yet.
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

/// The largest number of messages that a party may have begun and not completed.
[[nodiscard]] std::size_t streams_max_of(Party party);

} // namespace cd
