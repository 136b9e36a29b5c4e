// Proves what is measured of a worker: values and times in, the status out, without a clock.
#include "master/workers/worker_meter.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

WorkerMeter::Time at(std::chrono::milliseconds since_start) {
    return WorkerMeter::Time(since_start);
}

WorkerStatus status_of(const WorkerMeter& meter, std::chrono::milliseconds now) {
    WorkerStatus status;
    status.scenarios = 60;
    meter.add_to(status, at(now));
    return status;
}

TEST(WorkerMeter, TheRateCountsOnlyTimeWithWork) {
    WorkerMeter meter;
    EXPECT_EQ(status_of(meter, 9s).scenarios_per_second, 0) << "it never had work";
    meter.work_is(true, at(10s));
    meter.work_is(true, at(12s));
    EXPECT_DOUBLE_EQ(status_of(meter, 15s).scenarios_per_second, 12);
    meter.work_is(false, at(20s));
    meter.work_is(false, at(50s));
    EXPECT_DOUBLE_EQ(status_of(meter, 100s).scenarios_per_second, 6);
    meter.work_is(true, at(100s));
    EXPECT_DOUBLE_EQ(status_of(meter, 110s).scenarios_per_second, 3);
}

TEST(WorkerMeter, TheStatusShowsTheLastHeartbeat) {
    WorkerMeter meter(1000);
    EXPECT_EQ(status_of(meter, 0s).cache_bytes, 1000u);
    EXPECT_FALSE(status_of(meter, 0s).longest);
    CacheTraffic traffic;
    traffic.uploaded_bytes = 7;
    meter.heartbeat_came({1, 400, 0, traffic, RunningScenario{JobId{2}, 3, 75}});
    EXPECT_EQ(status_of(meter, 0s).cached_bytes, 400u);
    EXPECT_EQ(status_of(meter, 0s).cache, traffic);
    ASSERT_TRUE(meter.longest());
    EXPECT_EQ(status_of(meter, 0s).longest->scenario, 3u);
    meter.heartbeat_came({2, 300, 0, traffic, {}});
    EXPECT_FALSE(meter.longest());
}

TEST(WorkerMeter, BytesCountOnceAndOnANewConnection) {
    WorkerMeter meter;
    EXPECT_FALSE(meter.bytes_came(0));
    EXPECT_TRUE(meter.bytes_came(100));
    EXPECT_FALSE(meter.bytes_came(100));
    EXPECT_TRUE(meter.bytes_came(40)) << "another connection";
}

} // namespace
} // namespace cd::tests
