// Proves that endpoints are parsed as people write them, and that by default nothing leaves
// loopback.
#include "proto/channel/endpoint.hpp"

#include "tests/support/logged.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(Endpoint, ReadsNamesAndAddresses) {
    const auto v4 = parse_endpoint("127.0.0.1:7600");
    ASSERT_TRUE(v4);
    EXPECT_EQ(v4.value().host, "127.0.0.1");
    EXPECT_EQ(v4.value().port, 7600);
    EXPECT_EQ(parse_endpoint("[::1]:1").value().host, "::1");
    EXPECT_EQ(parse_endpoint("node-1.cluster:65535").value().port, 65535);
    EXPECT_EQ(parse_endpoint("localhost:0").value().port, 0);
}

TEST(Endpoint, RefusesWhatIsNoneAndSaysWhatIsExpected) {
    for (const char* text : {"",
                             "host",
                             "host:",
                             ":7600",
                             "host:port",
                             "host:-1",
                             "host:65536",
                             "host:76 00",
                             "::1:7600",
                             "[]:7600",
                             "a b:7600",
                             "[::1:7600",
                             "host:7600x",
                             "host: 7600"}) {
        const auto endpoint = parse_endpoint(text);
        ASSERT_FALSE(endpoint) << text;
        EXPECT_EQ(endpoint.error().code, ErrorCode::BadInput);
        EXPECT_THAT(endpoint.error().detail, testing::HasSubstr("HOST:PORT"));
    }
}

TEST(Endpoint, KnowsLoopback) {
    for (const char* host : {"127.0.0.1", "127.3.2.1", "::1", "localhost"}) {
        EXPECT_TRUE(is_loopback({host, 1})) << host;
    }
    for (const char* host :
         {"0.0.0.0", "::", "10.0.0.1", "128.0.0.1", "example.org", "127.0.0.1.evil"}) {
        EXPECT_FALSE(is_loopback({host, 1})) << host;
    }
}

TEST(Endpoint, BeyondLoopbackTheOptionIsNeeded) {
    EXPECT_TRUE(check_exposure({"127.0.0.1", 7600}, {false, false, true}));
    for (const bool listening : {false, true}) {
        const auto refused = check_exposure({"0.0.0.0", 7600}, {false, false, listening});
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::Refused);
        EXPECT_THAT(refused.error().detail, testing::HasSubstr("--insecure"));
        // Suppresses all other logging.
        const Logged logged(LogLevel::Off);
        EXPECT_TRUE(check_exposure({"0.0.0.0", 7600}, {false, true, listening}));
        EXPECT_THAT(logged.text(), testing::HasSubstr("warning test insecure: "));
        EXPECT_THAT(logged.text(), testing::HasSubstr(listening ? "listening" : "connecting"));
        EXPECT_TRUE(check_exposure({"0.0.0.0", 7600}, {true, false, listening}));
    }
}

} // namespace
} // namespace cd::tests
