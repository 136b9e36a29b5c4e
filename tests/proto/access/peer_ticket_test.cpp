// Proves that a ticket is valid once, for its purpose, with the key that made it.
#include "proto/access/peer_ticket.hpp"

#include "common/core/limits/wire.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

PeerFetch fetch_with(const PeerKey& key, std::uint64_t ticket) {
    PeerFetch fetch{TreeId{3}, {1, 2, 5}, ticket, {}};
    fetch.proof = ticket_proof(key, ticket, fetch.tree, fetch.roots);
    return fetch;
}

TEST(PeerTicket, IsTakenOnce) {
    const PeerKey key = random_secret();
    TicketCheck check(key);
    EXPECT_TRUE(check.take(fetch_with(key, 2)));
    EXPECT_FALSE(check.take(fetch_with(key, 2)));
    EXPECT_TRUE(check.take(fetch_with(key, 1))) << "tickets may overtake each other";
}

TEST(PeerTicket, IsForItsRootsItsTreeAndItsNumberAlone) {
    const PeerKey key = random_secret();
    TicketCheck check(key);
    const PeerFetch good = fetch_with(key, 1);
    PeerFetch roots = good;
    roots.roots.push_back(6);
    PeerFetch tree = good;
    tree.tree = TreeId{4};
    PeerFetch number = good;
    number.ticket = 2;
    for (const PeerFetch& forged : {roots, tree, number}) {
        EXPECT_FALSE(check.take(forged));
    }
    EXPECT_TRUE(check.take(good)) << "a forgery does not spend it";
}

TEST(PeerTicket, AnotherKeyIsRefused) {
    TicketCheck check(random_secret());
    EXPECT_FALSE(check.take(fetch_with(random_secret(), 1)));
    EXPECT_FALSE(check.take(fetch_with(PeerKey{}, 1)));
}

TEST(PeerTicket, AnExpiredTicketIsRefused) {
    const PeerKey key = random_secret();
    TicketCheck check(key);
    for (std::uint64_t ticket = 1; ticket <= limits::peer_tickets_remembered + 1; ++ticket) {
        ASSERT_TRUE(check.take(fetch_with(key, ticket)));
    }
    EXPECT_FALSE(check.take(fetch_with(key, 1))) << "forgotten, and yet not taken";
}

} // namespace
} // namespace cd::tests
