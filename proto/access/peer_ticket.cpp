#include "proto/access/peer_ticket.hpp"

#include "common/core/files/bytes.hpp"
#include "common/core/limits/wire.hpp"

namespace cd {

Sha256 ticket_proof(const PeerKey& key,
                    std::uint64_t ticket,
                    TreeId tree,
                    std::span<const RootIndex> roots) {
    ByteWriter out;
    out.put(ticket);
    out.put(tree.value);
    for (const RootIndex root : roots) {
        out.put(root);
    }
    return hmac_sha256(key, out.take());
}

bool TicketCheck::take(const PeerFetch& fetch) {
    const bool is_known =
        is_equal_secret(fetch.proof, ticket_proof(key_, fetch.ticket, fetch.tree, fetch.roots));
    if (!is_known || fetch.ticket <= forgotten_ || !taken_.insert(fetch.ticket).second) {
        return false;
    }
    if (taken_.size() > limits::peer_tickets_remembered) {
        forgotten_ = *taken_.begin();
        taken_.erase(taken_.begin());
    }
    return true;
}

} // namespace cd
