// Proves that one client has at most its share of connections, jobs and bytes, that a share comes
// back, and that one client's does not count for another.
#include "master/quotas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

const Quotas::Time start{};

TEST(Quotas, ConnectionsAreCountedByClientAndComeBack) {
    Quotas quotas({2, 9, 9, 1s});
    EXPECT_TRUE(quotas.connect("ann"));
    EXPECT_TRUE(quotas.connect("ann"));
    const Status third = quotas.connect("ann");
    EXPECT_EQ(third.error().code, ErrorCode::Refused);
    EXPECT_THAT(third.error().detail, testing::HasSubstr("2 connections"));
    EXPECT_TRUE(quotas.connect("bob"));
    quotas.disconnect("ann");
    EXPECT_TRUE(quotas.connect("ann"));
    quotas.disconnect("nobody");
    EXPECT_FALSE(quotas.connect("ann"));
}

TEST(Quotas, OnlyJobsThatRunCount) {
    Quotas quotas({9, 2, 9, 1s});
    bool first_runs = true;
    const auto is_running = [&](JobId job) { return job != JobId{1} || first_runs; };
    for (const std::uint64_t job : {1u, 2u}) {
        EXPECT_TRUE(quotas.check_jobs("ann", is_running));
        quotas.add_job("ann", JobId{job});
    }
    EXPECT_EQ(quotas.check_jobs("ann", is_running).error().code, ErrorCode::Refused);
    EXPECT_TRUE(quotas.check_jobs("bob", is_running));
    first_runs = false;
    EXPECT_TRUE(quotas.check_jobs("ann", is_running));
}

TEST(Quotas, BytesLeakAwayWithTime) {
    Quotas quotas({9, 9, 1000, 100s});
    EXPECT_TRUE(quotas.take_bytes("ann", 1000, start));
    EXPECT_EQ(quotas.take_bytes("ann", 1, start).error().code, ErrorCode::Refused);
    EXPECT_TRUE(quotas.take_bytes("bob", 1000, start));
    // Ten a second; what was refused did not count.
    EXPECT_FALSE(quotas.take_bytes("ann", 101, start + 10s));
    EXPECT_TRUE(quotas.take_bytes("ann", 100, start + 10s));
    EXPECT_FALSE(quotas.take_bytes("ann", 1, start + 10s));
    EXPECT_TRUE(quotas.take_bytes("ann", 1000, start + 1000s));
}

TEST(Quotas, NamesThatComeAndGoAreForgotten) {
    Quotas quotas;
    for (std::size_t i = 0; i < 2 * limits::connections_max + 2; ++i) {
        const std::string name = std::to_string(i);
        EXPECT_TRUE(quotas.connect(name));
        quotas.disconnect(name);
    }
    EXPECT_LE(quotas.clients(), limits::connections_max);
}

} // namespace
} // namespace cd::tests
