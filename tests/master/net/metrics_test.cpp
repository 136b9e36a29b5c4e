// Proves that the Prometheus page reports the values of the status, in its text format.
#include "master/net/metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

ClusterStatus make_status() {
    ClusterStatus status;
    status.build = "1.2.3";
    status.uptime_seconds = 12.5;
    status.alarm_count = 2;
    status.losses.workers_lost = 3;
    WorkerStatus good;
    good.worker = WorkerId{4};
    good.name = "blade \"3\"\n";
    good.scenarios = 1000;
    good.cache.blocks.peer_bytes = 77;
    WorkerStatus bad;
    bad.worker = WorkerId{5};
    bad.state = WorkerState::Lost;
    bad.quarantined = true;
    status.workers = {good, bad};
    JobStatus running;
    running.job = JobId{8};
    running.name = "night";
    running.summary.total = 500;
    running.summary.separate = 20;
    running.summary.cross = 3;
    running.paused = "no room";
    JobStatus done;
    done.job = JobId{7};
    done.state = JobState::Done;
    status.jobs = {done, running};
    return status;
}

TEST(Metrics, TheMetricsHaveTheNumbersOfTheStatus) {
    const std::string text = metrics_text(make_status());
    for (const char* const line :
         {"# TYPE cdcluster_alarms_total counter\n",
          "# HELP cdcluster_alarms_total Alarms raised; each needs an operator's attention.\n",
          "\ncdcluster_build_info{version=\"1.2.3\"} 1\n",
          "\ncdcluster_alarms_total 2\n",
          "\ncdcluster_uptime_seconds 12.5\n",
          "\ncdcluster_workers{state=\"alive\"} 1\n",
          "\ncdcluster_workers{state=\"silent\"} 0\n",
          "\ncdcluster_workers{state=\"lost\"} 1\n",
          "\ncdcluster_workers_quarantined 1\n",
          "\ncdcluster_workers_lost_total 3\n",
          "\ncdcluster_worker_scenarios_total{worker=\"4\",name=\"blade \\\"3\\\"\\n\"} 1000\n",
          "\ncdcluster_worker_block_peer_bytes_total{worker=\"4\",name=\"blade \\\"3\\\"\\n\"} "
          "77\n",
          "\ncdcluster_jobs{state=\"running\"} 1\n",
          "\ncdcluster_jobs{state=\"done\"} 1\n",
          "\ncdcluster_jobs_paused 1\n",
          "\ncdcluster_job_scenarios{job=\"8\",name=\"night\"} 500\n",
          "\ncdcluster_job_scenarios_done{job=\"8\",name=\"night\"} 23\n"}) {
        EXPECT_THAT(text, HasSubstr(line));
    }
    EXPECT_THAT(text, Not(HasSubstr("job=\"7\""))) << "it does not run";
}

TEST(Metrics, AnEmptyClusterHasAPage) {
    const std::string text = metrics_text({});
    EXPECT_THAT(text, HasSubstr("\ncdcluster_workers{state=\"alive\"} 0\n"));
    EXPECT_EQ(text.back(), '\n');
}

} // namespace
} // namespace cd::tests
