// Single-use tickets of the master that let one worker fetch blocks from another.
#pragma once

#include "common/core/limits/wire.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <set>
#include <span>

namespace cd {

/// Returns the master's proof of a ticket, which authorises one fetch of these roots from the
/// worker that shares this key with the master.
[[nodiscard]] Sha256 ticket_proof(const PeerKey& key,
                                  std::uint64_t ticket,
                                  TreeId tree,
                                  std::span<const RootIndex> roots);

/// Checks the tickets that one serving worker receives. The master numbers them from 1.
class TicketCheck {
  public:
    explicit TicketCheck(const PeerKey& key) : key_(key) {}

    /// Uses up the ticket of a fetch. Returns false if the ticket is invalid, was used before, or
    /// has a lower number than the highest `limits::peer_tickets_remembered` that were used.
    [[nodiscard]] bool take(const PeerFetch& fetch);

  private:
    PeerKey key_;
    std::uint64_t forgotten_ = 0;   ///< Tickets up to this number are refused.
    std::set<std::uint64_t> taken_; ///< Used tickets, all above `forgotten_`.
};

} // namespace cd
