// Proves that no host takes all connection slots of unidentified peers.
#include "proto/access/seats.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace cd::tests {
namespace {

asio::ip::address address(const char* text) {
    return asio::ip::make_address(text);
}

/// Takes as many slots as the host gets.
std::vector<Seats::Seat> take_all(Seats& seats, const asio::ip::address& from) {
    std::vector<Seats::Seat> taken;
    while (auto seat = seats.take(from)) {
        taken.push_back(std::move(seat));
    }
    return taken;
}

TEST(Seats, AHostAloneGetsHalfOfThem) {
    Seats seats(512);
    const auto first = take_all(seats, address("127.0.0.1"));
    EXPECT_EQ(first.size(), 256u);
    EXPECT_TRUE(seats.take(address("127.0.0.2")));
}

TEST(Seats, SeveralThatWantAllLeaveSomeForTheNext) {
    Seats seats(512);
    // The hosts take turns, so each gets equally many.
    std::vector<Seats::Seat> taken;
    for (bool any = true; any;) {
        any = false;
        for (const char* host : {"10.0.0.1", "10.0.0.2", "10.0.0.3"}) {
            if (auto seat = seats.take(address(host))) {
                taken.push_back(std::move(seat));
                any = true;
            }
        }
    }
    EXPECT_EQ(taken.size(), 3u * 128);
    EXPECT_FALSE(seats.take(address("10.0.0.2")));
    EXPECT_TRUE(seats.take(address("10.0.0.4")));
}

TEST(Seats, ASeatIsFreeWhenNothingSharesIt) {
    Seats seats(2);
    Seats::Seat seat = seats.take(address("::1"));
    Seats::Seat shared = seat;
    EXPECT_FALSE(seats.take(address("::1")));
    seat.reset();
    EXPECT_EQ(seats.taken(), 1u);
    EXPECT_FALSE(seats.take(address("::1")));
    shared.reset();
    EXPECT_EQ(seats.taken(), 0u);
    EXPECT_TRUE(seats.take(address("::1")));
}

TEST(Seats, ReleasingASlotAfterTheSeatsIsSafe) {
    std::optional<Seats> seats(4);
    Seats::Seat seat = seats->take(address("::1"));
    seats.reset();
    seat.reset();
}

TEST(Seats, RefusesWhenFull) {
    Seats seats(3);
    // The address of a closed connection is unknown.
    const auto gone = take_all(seats, asio::ip::address());
    EXPECT_EQ(gone.size(), 3u);
    EXPECT_FALSE(seats.take(address("10.0.0.1")));
}

TEST(Seats, ANetworkOfAHostIsAHost) {
    EXPECT_EQ(host_of(address("2001:db8:1:2:3:4:5:6")), host_of(address("2001:db8:1:2::")));
    EXPECT_NE(host_of(address("2001:db8:1:2::")), host_of(address("2001:db8:1:3::")));
    EXPECT_EQ(host_of(address("::ffff:10.1.2.3")), address("10.1.2.3"));
    EXPECT_NE(host_of(address("10.1.2.3")), host_of(address("10.1.2.4")));
}

} // namespace
} // namespace cd::tests
