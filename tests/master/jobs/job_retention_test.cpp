// Proves which values --keep-jobs accepts, and which jobs are dropped.
#include "master/jobs/job_retention.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

TEST(JobRetention, IsANumberOfJobsOrATime) {
    EXPECT_EQ(parse_retention("17").value().count, 17u);
    EXPECT_EQ(parse_retention("17").value().age, std::nullopt);
    EXPECT_EQ(parse_retention("30d").value().age, 30 * 24h);
    EXPECT_EQ(parse_retention("30d").value().count, limits::jobs_kept_max);
    for (const char* wrong : {"", "0", "-1", "30 d", "0d", "soon", "1000000"}) {
        EXPECT_EQ(parse_retention(wrong).error().code, ErrorCode::BadInput) << wrong;
    }
}

TEST(JobRetention, AJobMayAskForLessTimeAndNotForMore) {
    const JobRetention a_minute{10, 60s};
    EXPECT_FALSE(a_minute.is_over(1000, 0, 1060));
    EXPECT_TRUE(a_minute.is_over(1000, 0, 1061));
    EXPECT_TRUE(a_minute.is_over(1000, 30, 1031));
    EXPECT_TRUE(a_minute.is_over(1000, 300, 1061));
    EXPECT_FALSE(a_minute.is_over(1000, 0, 900)) << "the clock was set back";
    const JobRetention by_number;
    EXPECT_FALSE(by_number.is_over(1000, 0, 1'000'000));
    EXPECT_TRUE(by_number.is_over(1000, 30, 1031));
}

} // namespace
} // namespace cd::tests
