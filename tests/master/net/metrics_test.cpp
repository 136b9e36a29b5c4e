// Proves that the Prometheus page reports the values of the status, in its text format.
#include "master/net/metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

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
    const std::string text = metrics_text(make_status(), {});
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

MasterFigures make_figures() {
    MasterFigures figures;
    figures.written = {900, 12345};
    figures.commits.commits = {5, 0, 2, 0, 0, 0, 0, 0, 0, 1};
    figures.commits.seconds = 11.5;
    figures.disk_bytes = 4000;
    figures.certificate_until = 1'800'000'000;
    figures.now = 1'700'000'500.5;
    figures.process.started = 1'700'000'000.25;
    figures.process.open_files = 17;
    figures.http_answers = {{200, 40}, {404, 2}};
    figures.workers = {{WorkerId{4}, "blade", "0.2.0", BlockDelivery::PeerPort{4021, false}},
                       {WorkerId{5}, "saw", "0.1.0", std::nullopt}};
    return figures;
}

TEST(Metrics, TheMetricsHaveTheFiguresOfTheMaster) {
    ClusterStatus status = make_status();
    status.sizes.free = 1000;
    status.cpu_seconds = 3.5;
    const std::string text = metrics_text(status, make_figures());
    for (const char* const line :
         {"# TYPE cdcluster_scenarios_total counter\n",
          "\ncdcluster_scenarios_total 900\n",
          "\ncdcluster_results_bytes_total 12345\n",
          "# TYPE cdcluster_journal_commit_seconds histogram\n",
          "\ncdcluster_journal_commit_seconds_count 8\n",
          "\ncdcluster_journal_commit_seconds_sum 11.5\n",
          "\ncdcluster_journal_commit_seconds_bucket{le=\"0.001\"} 5\n",
          "\ncdcluster_journal_commit_seconds_bucket{le=\"0.01\"} 7\n",
          "\ncdcluster_journal_commit_seconds_bucket{le=\"10\"} 7\n",
          "\ncdcluster_journal_commit_seconds_bucket{le=\"+Inf\"} 8\n",
          "\ncdcluster_state_free_bytes 1000\n",
          "\ncdcluster_state_total_bytes 4000\n",
          "\ncdcluster_certificate_expires_timestamp_seconds 1800000000\n",
          "\ncdcluster_http_requests_total{code=\"200\"} 40\n",
          "\ncdcluster_http_requests_total{code=\"404\"} 2\n",
          "\ncdcluster_process_cpu_seconds_total 3.5\n",
          "\ncdcluster_process_start_time_seconds 1700000000.25\n",
          "\ncdcluster_process_open_fds 17\n",
          "\ncdcluster_time_seconds 1700000500.5\n",
          "\ncdcluster_worker_info{worker=\"5\",name=\"saw\",version=\"0.1.0\"} 1\n",
          "\ncdcluster_worker_peer_reachable{worker=\"4\",name=\"blade\",port=\"4021\"} 0\n"}) {
        EXPECT_THAT(text, HasSubstr(line));
    }
    EXPECT_THAT(text, Not(HasSubstr("peer_reachable{worker=\"5\""))) << "it serves no others";
}

TEST(Metrics, WhatIsUnknownIsLeftOut) {
    const std::string text = metrics_text({}, {});
    EXPECT_THAT(text, Not(HasSubstr("state_free_bytes")));
    EXPECT_THAT(text, Not(HasSubstr("certificate_expires")));
}

TEST(Metrics, AProcessTellsItsOwnFigures) {
    const ProcessFigures figures = process_figures();
    const double now =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    EXPECT_GT(figures.started, now - 24 * 3600.0);
    EXPECT_LE(figures.started, now + 1);
    EXPECT_GT(figures.resident_bytes, 1u << 20);
    EXPECT_GT(figures.virtual_bytes, figures.resident_bytes);
    EXPECT_GE(figures.threads, 1u);
    EXPECT_GE(figures.open_files, 3u);
    EXPECT_GE(figures.open_files_max, figures.open_files);
    const std::ifstream one_more("/proc/self/stat");
    EXPECT_EQ(process_figures().open_files, figures.open_files + 1);
}

TEST(Metrics, AnEmptyClusterHasAPage) {
    const std::string text = metrics_text({}, {});
    EXPECT_THAT(text, HasSubstr("\ncdcluster_workers{state=\"alive\"} 0\n"));
    EXPECT_EQ(text.back(), '\n');
}

} // namespace
} // namespace cd::tests
