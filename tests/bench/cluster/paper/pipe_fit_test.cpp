// Proves that the pipe's rate is fitted by all times together, and only by times that fall with it.
#include "bench/cluster/paper/pipe_fit.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cd::bench::tests {
namespace {

/// A job of 100 s and 4 GB, with a time off by `error` at each second rate.
std::vector<TimeAtRate> times(double error) {
    std::vector<TimeAtRate> all;
    for (const double rate : {1e7, 2e7, 3e7, 4e7, 5e7, 6e7, 7e7, 8e7}) {
        error = -error;
        all.push_back({rate, 100 + 4e9 / rate + error});
    }
    return all;
}

TEST(PipeFit, FindsTheRateOfATime) {
    EXPECT_NEAR(rate_on_line(times(0), 300).value(), 2e7, 1);
    EXPECT_NEAR(rate_on_line(times(0), 200).value(), 4e7, 1);
}

TEST(PipeFit, EvensOutTimesThatAreOff) {
    EXPECT_NEAR(rate_on_line(times(20), 300).value(), 2e7, 2e6);
}

TEST(PipeFit, FindsNoRateForATimeBelowAnyOrWithoutAFallingLine) {
    EXPECT_FALSE(rate_on_line(times(0), 99));
    EXPECT_FALSE(rate_on_line({}, 300));
    EXPECT_FALSE(rate_on_line(std::vector<TimeAtRate>{{1e7, 100}}, 300));
    EXPECT_FALSE(rate_on_line(std::vector<TimeAtRate>{{1e7, 100}, {2e7, 200}}, 150));
}

} // namespace
} // namespace cd::bench::tests
