// Proves that durations in the usual spelling are parsed, and all else is rejected.
#include "common/core/duration.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

TEST(Duration, HasANumberAndAUnit) {
    EXPECT_EQ(parse_duration("45s").value(), 45s);
    EXPECT_EQ(parse_duration("30m").value(), 30min);
    EXPECT_EQ(parse_duration("24h").value(), 24h);
    EXPECT_EQ(parse_duration("7d").value(), 168h);
    EXPECT_EQ(parse_duration("0s").value(), 0s);
}

TEST(Duration, MalformedTextIsRefused) {
    for (const char* text :
         {"", "h", "7", "7 d", "7w", "-1h", "1.5h", "1h30m", "99999999999999999999s", "36501d"}) {
        EXPECT_EQ(parse_duration(text).error().code, ErrorCode::BadInput) << text;
    }
}

} // namespace
} // namespace cd::tests
