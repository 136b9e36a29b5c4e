// Proves for how long a worker retries after TLS refusals.
#include "worker/membership/refusal_patience.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr RefusalPatience::Time start{};

TEST(RefusalPatience, AWorkerThatNoMasterAcceptedDoesNotTryAgain) {
    RefusalPatience patience;
    EXPECT_EQ(patience.refused(start), 0s);
}

TEST(RefusalPatience, AWorkerThatWasAcceptedTriesAgainForAnHour) {
    RefusalPatience patience;
    patience.accepted();
    EXPECT_EQ(patience.refused(start), 1h);
    EXPECT_EQ(patience.refused(start + 59min), 1min);
    EXPECT_EQ(patience.refused(start + 1h), 0s);
    EXPECT_EQ(patience.refused(start + 2h), 0s);
}

TEST(RefusalPatience, AnAcceptanceBeginsTheHourAnew) {
    RefusalPatience patience;
    patience.accepted();
    EXPECT_EQ(patience.refused(start), 1h);
    patience.accepted();
    EXPECT_EQ(patience.refused(start + 59min), 1h);
}

} // namespace
} // namespace cd::tests
