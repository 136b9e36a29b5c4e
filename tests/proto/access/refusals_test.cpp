// Proves that repeated refusals of a peer do not fill the log, and that the log gives their number.
#include "proto/access/refusals.hpp"

#include "common/core/limits/wire.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr Refusals::Time start{1h};

/// Causes so many lines that more are suppressed.
void write_all(Refusals& refusals, const std::string& host, Refusals::Time now) {
    for (std::size_t i = 0; i < limits::refusal_lines_max; ++i) {
        EXPECT_EQ(refusals.admit(host, now), 0u);
    }
}

TEST(Refusals, AFewLinesInAPeriodTellOfTheOthers) {
    Refusals refusals;
    write_all(refusals, "10.0.0.1", start);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_FALSE(refusals.admit("10.0.0.1", start + 500ms));
    }
    EXPECT_EQ(refusals.admit("10.0.0.2", start + 500ms), 0u) << "another host";
    EXPECT_EQ(refusals.admit("10.0.0.1", start + 1s), 1000u);
    EXPECT_EQ(refusals.admit("10.0.0.1", start + 1s), 0u);
    EXPECT_EQ(refusals.admit("10.0.0.1", start + 1h), 0u);
}

TEST(Refusals, HostsWithoutEndAreOne) {
    Refusals refusals;
    for (std::size_t i = 0; i < limits::refusal_hosts_max; ++i) {
        EXPECT_EQ(refusals.admit(std::to_string(i), start), 0u);
    }
    write_all(refusals, "one more", start);
    EXPECT_FALSE(refusals.admit("and another", start));
    // A peer that is not refused again is forgotten.
    write_all(refusals, "late", start + 1s);
    EXPECT_EQ(refusals.admit("later", start + 1s), 0u);
}

} // namespace
} // namespace cd::tests
