// Who may send what, and how much of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cd {

enum class Role : std::uint8_t;

/// What the other end of a connection is known to be.
enum class Party : std::uint8_t {
    Stranger, ///< It has not greeted yet.
    Anyone,   ///< It has, and nobody has looked as what.
    Joiner,
    Observer, ///< A client that may look at the cluster, and no more.
    Client,
    Worker,
    Peer,  ///< A worker that fetches from another one,
    Giver, ///< which this is.
    Master,
};

/// What says a hello in this role.
[[nodiscard]] Party party_of(Role role);
[[nodiscard]] std::string_view to_text(Party party);

/// The most bytes that a message of this type may have when it comes from there; 0: none comes.
[[nodiscard]] std::uint64_t payload_bytes_max_from(Party party, std::uint16_t type);
/// Messages that it may have begun.
[[nodiscard]] std::size_t streams_max_of(Party party);

} // namespace cd
