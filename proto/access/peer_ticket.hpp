// Tickets by which the master lets one worker fetch blocks from another, once.
#pragma once

#include "common/core/limits/wire.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <set>
#include <span>

namespace cd {

/// What the master shows for a ticket of this number, for these roots, to the worker whose key it
/// is.
[[nodiscard]] Sha256 ticket_proof(const PeerKey& key,
                                  std::uint64_t ticket,
                                  TreeId tree,
                                  std::span<const RootIndex> roots);

/// The tickets that came to one source. The master counts them from 1 up.
class TicketCheck {
  public:
    explicit TicketCheck(const PeerKey& key) : key_(key) {}

    /// True once for each ticket of the master, while it is among the last
    /// `limits::peer_tickets_remembered`.
    [[nodiscard]] bool take(const PeerFetch& fetch);

  private:
    PeerKey key_;
    std::uint64_t forgotten_ = 0;   ///< Tickets up to here are not taken.
    std::set<std::uint64_t> taken_; ///< All greater.
};

} // namespace cd
