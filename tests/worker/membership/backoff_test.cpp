// Proves that pauses grow to their limit, vary, and start anew.
#include "worker/membership/backoff.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

TEST(Backoff, GrowsToItsLimitAndVaries) {
    Backoff backoff(1);
    for (int i = 0; i < 40; ++i) {
        const auto pause = backoff.next();
        EXPECT_GE(pause.count(), 50);
        EXPECT_LE(pause.count(), 5000);
        if (i > 8) {
            EXPECT_GE(pause.count(), 2500);
        }
    }
    backoff.reset();
    EXPECT_LE(backoff.next().count(), 100);
}

} // namespace
} // namespace cd::tests
