// Proves what the doctor says of each fault, and that it says nothing of what is well.
#include "client/commands/doctor/cluster_checks.hpp"
#include "client/commands/doctor/finding.hpp"
#include "client/commands/doctor/own_checks.hpp"
#include "common/core/errors.hpp"
#include "common/core/version.hpp"
#include "tests/support/process.hpp"
#include "web/status/job_id.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using Grade = Finding::Grade;
using Wall = std::chrono::system_clock;

constexpr std::uint64_t gigabyte = 1u << 30;

// ---- This machine and its user --------------------------------------------------------------

TEST(DoctorOfThisMachine, ThreadsAndMemoryAreTold) {
    EXPECT_EQ(machine_finding({Done{}, "avx512", 32, 61 * gigabyte}),
              (Finding{Grade::Ok, "this machine", "avx512, 32 threads, 61.0 GiB free memory"}));
    const Finding small = machine_finding({Done{}, "avx2", 1, 300u << 20});
    EXPECT_EQ(small.grade, Grade::Warn);
    EXPECT_THAT(small.text, HasSubstr("avx2, 1 thread, 300.0 MiB free memory: large meshes"));
    const Finding simd =
        machine_finding({bad_input("CD_SIMD: no target 'mmx'"), "avx2", 1, gigabyte});
    EXPECT_EQ(simd.grade, Grade::Fail);
    EXPECT_EQ(simd.text, "CD_SIMD: no target 'mmx'");
    EXPECT_GT(free_memory(), 1u << 20);
}

TEST(DoctorOfTheTreeCache, ItsSizeIsTold) {
    const TemporaryFolder folder;
    EXPECT_EQ(tree_cache_finding("").grade, Grade::Ok);
    const auto cache = folder / "trees";
    EXPECT_THAT(tree_cache_finding(cache).text, EndsWith("/trees, 0 B of 4.0 GiB"));
    std::filesystem::create_directories(cache / "meshes");
    write_text(cache / "ab.wide-tree", std::string(2048, 'x'));
    write_text(cache / "ab.points", std::string(1024, 'x'));
    write_text(cache / "notes.txt", std::string(5000, 'x'));
    const Finding finding = tree_cache_finding(cache);
    EXPECT_EQ(finding.grade, Grade::Ok);
    EXPECT_THAT(finding.text, EndsWith("/trees, 3.0 KiB of 4.0 GiB"));
}

TEST(DoctorOfTheTreeCache, AFolderThatCannotBeMadeIsAWarning) {
    const TemporaryFolder folder;
    write_text(folder / "file", "");
    const Finding finding = tree_cache_finding(folder / "file" / "trees");
    EXPECT_EQ(finding.grade, Grade::Warn);
    EXPECT_THAT(finding.text, HasSubstr("/file is no folder), so each run builds its trees"));
    EXPECT_EQ(tree_cache_finding(folder / "file").grade, Grade::Warn);
}

std::optional<Identity> identity_between(Wall::time_point from, Wall::time_point until) {
    return Identity{CertifiedRole::Submitter, "ilan", from, until};
}

TEST(DoctorOfTheCredential, ItsLifeIsTold) {
    const Wall::time_point now{1'700'000'000s};
    const auto finding_for = [&](std::chrono::seconds from, std::chrono::seconds until) {
        return credential_finding(identity_between(now + from, now + until), now);
    };
    EXPECT_EQ(finding_for(-1h, 6 * 24h),
              (Finding{Grade::Ok, "credential", "good for 6 days; it renews when cdctl is used"}));
    EXPECT_EQ(
        finding_for(-1h, 9h),
        (Finding{Grade::Warn, "credential", "good for 9 hours; it renews when cdctl is used"}));
    EXPECT_EQ(finding_for(-24h, -3h),
              (Finding{Grade::Fail, "credential", "ended 3 hours ago; `cdctl join` gets another"}));
    const Finding early = finding_for(2min, 24h);
    EXPECT_EQ(early.grade, Grade::Fail);
    EXPECT_THAT(early.text, StartsWith("valid only in 2 minutes: is this machine's clock right?"));
    EXPECT_EQ(credential_finding(std::optional<Identity>(), now).grade, Grade::Ok);
    const Finding unreadable = credential_finding(
        Result<std::optional<Identity>>(Error{ErrorCode::Refused, "me.pem: others may read it"}),
        now);
    EXPECT_EQ(unreadable.grade, Grade::Fail);
    EXPECT_EQ(unreadable.text, "me.pem: others may read it");
}

TEST(DoctorOfTheCredential, TimesAreInTheirLargestUnit) {
    EXPECT_EQ(lasting(0s), "0 seconds");
    EXPECT_EQ(lasting(-5s), "0 seconds");
    EXPECT_EQ(lasting(59s), "59 seconds");
    EXPECT_EQ(lasting(60s), "1 minute");
    EXPECT_EQ(lasting(7199s), "1 hour");
    EXPECT_EQ(lasting(48h), "2 days");
}

// ---- The cluster ----------------------------------------------------------------------------

constexpr double now_seconds = 1'700'000'000;

ClusterFacts sound_facts() {
    ClusterFacts facts;
    facts.address = "node-1:7600";
    facts.owner = "ilan";
    facts.role = "submitter";
    facts.is_tls = true;
    facts.status.build = std::string(version);
    facts.status.uptime_seconds = 1000;
    facts.status.sizes.free = 210 * gigabyte;
    facts.status_time = Wall::time_point(1'700'000'000s);
    facts.metrics_time = facts.status_time;
    facts.no_metrics = "nobody asked";
    for (const std::uint64_t id : {4u, 7u}) {
        WorkerStatus worker;
        worker.worker = WorkerId{id};
        worker.name = "node-0" + std::to_string(id);
        facts.status.workers.push_back(worker);
    }
    return facts;
}

/// Returns the metrics of the cluster of `sound_facts`, followed by `more`.
MasterMetrics metrics_with(const std::string& more) {
    const auto samples = parse_metrics("cdcluster_uptime_seconds 1001\n" + more);
    EXPECT_TRUE(samples) << samples.error().detail;
    return {samples.value()};
}

std::string worker_info(int worker, const std::string& build) {
    return "cdcluster_worker_info{worker=\"" + std::to_string(worker) + "\",name=\"n\",version=\"" +
           build + "\"} 1\n";
}

TEST(DoctorOfAMaster, ASoundOneIsTold) {
    ClusterFacts facts = sound_facts();
    facts.metrics = metrics_with("cdcluster_time_seconds 1700000000.3\n");
    EXPECT_EQ(master_finding(facts),
              (Finding{Grade::Ok,
                       "master",
                       "node-1:7600, version " + std::string(version) +
                           " as here, TLS, you are `ilan` (submitter), clock +0.3 s"}));
}

TEST(DoctorOfAMaster, AnotherVersionIsAWarning) {
    ClusterFacts facts = sound_facts();
    facts.status.build = "0.0.7";
    const Finding finding = master_finding(facts);
    EXPECT_EQ(finding.grade, Grade::Warn);
    EXPECT_THAT(finding.text, HasSubstr("version 0.0.7, here " + std::string(version) + ", TLS"));
    EXPECT_THAT(finding.text, EndsWith("install the same release on both"));
}

TEST(DoctorOfAMaster, PlainTextIsAWarningBeyondLoopback) {
    ClusterFacts facts = sound_facts();
    facts.is_tls = false;
    facts.role.clear();
    EXPECT_EQ(master_finding(facts).grade, Grade::Warn);
    EXPECT_THAT(master_finding(facts).text, HasSubstr("no TLS, you are `ilan`; anyone on the"));
    facts.is_loopback = true;
    EXPECT_EQ(master_finding(facts).grade, Grade::Ok);
}

TEST(DoctorOfAMaster, AWrongClockIsAFault) {
    ClusterFacts facts = sound_facts();
    facts.metrics = metrics_with("cdcluster_time_seconds 1699999960\n");
    EXPECT_EQ(master_finding(facts).grade, Grade::Warn);
    EXPECT_THAT(master_finding(facts).text, HasSubstr("clock -40.0 s: set the clocks by NTP"));
    facts.metrics = metrics_with("cdcluster_time_seconds 1700000400\n");
    EXPECT_EQ(master_finding(facts).grade, Grade::Fail);
}

TEST(DoctorOfAMaster, ARunningJobTellsTheClock) {
    ClusterFacts facts = sound_facts();
    EXPECT_FALSE(clock_ahead(facts));
    JobStatus job;
    job.began = static_cast<std::uint64_t>(now_seconds) - 100;
    job.seconds = 60.5;
    job.state = JobState::Done;
    facts.status.jobs = {job};
    EXPECT_FALSE(clock_ahead(facts)) << "it does not run";
    facts.status.jobs[0].state = JobState::Running;
    EXPECT_NEAR(clock_ahead(facts).value(), -39, 1e-6);
    facts.status.uptime_seconds = 50;
    EXPECT_FALSE(clock_ahead(facts)) << "the master was down meanwhile";
}

TEST(DoctorOfAMaster, MetricsOfAnotherMasterAreKnown) {
    EXPECT_TRUE(is_of_master(metrics_with(""), sound_facts().status));
    ClusterStatus other;
    other.uptime_seconds = 5;
    EXPECT_FALSE(is_of_master(metrics_with(""), other));
    EXPECT_FALSE(is_of_master({}, other));
}

TEST(DoctorOfWorkers, SoundOnesAreOneLine) {
    ClusterFacts facts = sound_facts();
    EXPECT_THAT(worker_findings(facts),
                ElementsAre(Finding{Grade::Ok,
                                    "workers",
                                    "2 workers; their versions and ports are unknown: nobody "
                                    "asked"}));
    facts.metrics = metrics_with(worker_info(4, std::string(version)) +
                                 "cdcluster_worker_peer_reachable{worker=\"4\",port=\"1\"} 1\n");
    EXPECT_THAT(worker_findings(facts),
                ElementsAre(Finding{Grade::Ok,
                                    "workers",
                                    "2 workers, version " + std::string(version) +
                                        ", each can be reached by the others"}));
}

TEST(DoctorOfWorkers, AnotherVersionIsAFault) {
    ClusterFacts facts = sound_facts();
    facts.metrics = metrics_with(worker_info(4, std::string(version)) + worker_info(7, "0.0.7") +
                                 worker_info(99, "0.0.1"));
    EXPECT_THAT(worker_findings(facts),
                ElementsAre(Finding{Grade::Fail,
                                    "workers",
                                    "w-7 node-07: version 0.0.7, the master " +
                                        std::string(version) + ": upgrade it"}));
}

TEST(DoctorOfWorkers, APortThatOthersCannotReachIsAWarning) {
    ClusterFacts facts = sound_facts();
    facts.metrics =
        metrics_with("cdcluster_worker_peer_reachable{worker=\"4\",name=\"n\",port=\"40211\"} 0\n");
    EXPECT_THAT(worker_findings(facts),
                ElementsAre(Finding{Grade::Warn,
                                    "workers",
                                    "w-4 node-04: others cannot reach its port 40211 "
                                    "(firewall?), so the master serves"}));
}

TEST(DoctorOfWorkers, NoneASilentALostAndAWrongOneAreTold) {
    ClusterFacts facts = sound_facts();
    facts.status.workers[0].state = WorkerState::Silent;
    facts.status.workers[0].silent_seconds = 9;
    facts.status.workers[1].quarantined = true;
    const auto findings = worker_findings(facts);
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].grade, Grade::Warn);
    EXPECT_THAT(findings[0].text, StartsWith("w-4 node-04: silent for 9 s"));
    EXPECT_EQ(findings[1].grade, Grade::Fail);
    EXPECT_THAT(findings[1].text, StartsWith("w-7 node-07: it gave a wrong result"));
    facts.status.workers.pop_back();
    facts.status.workers[0].state = WorkerState::Lost;
    const auto lost = worker_findings(facts);
    ASSERT_EQ(lost.size(), 2u);
    EXPECT_THAT(lost[0].text, HasSubstr("lost; others do its work"));
    EXPECT_EQ(
        lost[1],
        (Finding{Grade::Warn, "workers", "none is here: start cdworker --master node-1:7600"}));
}

TEST(DoctorOfJobs, PausedJobsAndAlarmsAreTold) {
    ClusterFacts facts = sound_facts();
    EXPECT_TRUE(job_findings(facts).empty());
    JobStatus job;
    job.job = JobId{8};
    job.paused = "no space left on device";
    facts.status.jobs = {job};
    facts.status.alarm_count = 2;
    facts.status.alarms = {"first", "w-3 was wrong"};
    const std::string id = job_id_text(JobId{8});
    EXPECT_THAT(
        job_findings(facts),
        ElementsAre(Finding{Grade::Fail, "jobs", id + " is paused: no space left on device"},
                    Finding{Grade::Warn, "alarms", "2 alarms, the last: w-3 was wrong"}));
}

TEST(DoctorOfTheDisk, LittleRoomIsAFault) {
    ClusterFacts facts = sound_facts();
    EXPECT_EQ(disk_finding(facts),
              (Finding{Grade::Ok, "disk", "master has 210.0 GiB for its state"}));
    facts.metrics = metrics_with("cdcluster_state_total_bytes 1e12\n");
    EXPECT_EQ(disk_finding(facts).grade, Grade::Ok);
    facts.metrics = metrics_with("cdcluster_state_total_bytes 1e13\n");
    EXPECT_EQ(disk_finding(facts).grade, Grade::Warn);
    EXPECT_THAT(disk_finding(facts).text, HasSubstr("210.0 GiB of 9.1 TiB for its state; `cdctl"));
    facts.status.sizes.free = gigabyte / 2;
    EXPECT_EQ(disk_finding(facts).grade, Grade::Fail);
}

TEST(DoctorsFindings, AreColumnsOrJson) {
    const std::vector<Finding> findings{{Grade::Ok, "this machine", "avx2"},
                                        {Grade::Warn, "credential", "ends"},
                                        {Grade::Fail, "workers", "w-1 \x1b[31mred"}};
    EXPECT_THAT(findings_text(findings),
                ContainsRegex("^ok    this machine     avx2\nwarn  credential       ends\n"
                              "FAIL  workers          w-1 .*red\n$"));
    EXPECT_THAT(findings_text(findings), testing::Not(HasSubstr("\x1b")));
    EXPECT_THAT(findings_json(findings),
                HasSubstr("\"grade\": \"FAIL\",\n    \"topic\": \"workers\""));
}

} // namespace
} // namespace cd::tests
