// Single-use tickets of the master that let one worker fetch blocks from another.
#pragma once

#include "common/core/limits/wire.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <set>
#include <span>

namespace cd {

/// The master's proof of a ticket: it authorises a fetch of these roots from the worker with this
/// key.
[[nodiscard]] Sha256 ticket_proof(const PeerKey& key,
                                  std::uint64_t ticket,
                                  TreeId tree,
                                  std::span<const RootIndex> roots);

/// Checks the tickets that one source receives. The master numbers them from 1.
class TicketCheck {
  public:
    explicit TicketCheck(const PeerKey& key) : key_(key) {}

    /// True once for each valid ticket, while it is among the last
    /// `limits::peer_tickets_remembered`.
    [[nodiscard]] bool take(const PeerFetch& fetch);

  private:
    PeerKey key_;
    std::uint64_t forgotten_ = 0;   ///< Tickets up to this number are refused.
    std::set<std::uint64_t> taken_; ///< Used tickets, all above `forgotten_`.
};

} // namespace cd
