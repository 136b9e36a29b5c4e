// Proves that job ids are short and distinct, and that what people type of them finds the job.

#include "web/status/job_id.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace cd::tests {
namespace {

std::vector<JobId> first_jobs(std::uint64_t count) {
    std::vector<JobId> jobs(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        jobs[i].value = i + 1;
    }
    return jobs;
}

TEST(JobIdText, IsShortAndTellsJobsApart) {
    const auto jobs = first_jobs(500);
    std::set<std::string> ids;
    for (const JobId job : jobs) {
        const std::string id = job_id_text(job, jobs);
        EXPECT_EQ(id.substr(0, 2), "j-");
        EXPECT_GE(id.size(), 6u);
        EXPECT_LE(id.size(), 10u);
        EXPECT_EQ(id.substr(0, 6), job_id_text(job));
        ids.insert(id);
        const auto found = find_job(id, jobs);
        ASSERT_TRUE(found) << found.error().detail;
        EXPECT_EQ(found.value(), job);
    }
    EXPECT_EQ(ids.size(), jobs.size());
}

TEST(FindJob, TakesNumbersAndBeginningsWithAndWithoutTheirPrefix) {
    const auto jobs = first_jobs(3);
    const std::string id = job_id_text(JobId{2}, jobs);
    EXPECT_EQ(find_job("2", jobs).value(), JobId{2});
    EXPECT_EQ(find_job(id, jobs).value(), JobId{2});
    EXPECT_EQ(find_job(id.substr(2), jobs).value(), JobId{2});
    EXPECT_EQ(find_job(id.substr(0, 5), jobs).value(), JobId{2});
}

TEST(FindJob, NamesThoseThatCouldBeMeant) {
    const auto jobs = first_jobs(100);
    const std::string beginning = job_id_text(JobId{1}).substr(0, 3);
    std::string names;
    int count = 0;
    for (const JobId job : jobs) {
        const std::string id = job_id_text(job, jobs);
        if (id.starts_with(beginning) && ++count <= 5) {
            names += (names.empty() ? "" : ", ") + id;
        }
    }
    ASSERT_GT(count, 1);
    const auto found = find_job(beginning, jobs);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::BadInput);
    EXPECT_EQ(found.error().detail, "more than one job begins with '" + beginning + "': " + names);
}

TEST(FindJob, KnowsNoOtherJobs) {
    const auto jobs = first_jobs(3);
    for (const char* text : {"", "j-", "4", "zzzz", "j-2", "-1", "99999999999999999999999"}) {
        EXPECT_EQ(find_job(text, jobs).error().code, ErrorCode::NotFound) << text;
    }
    EXPECT_EQ(find_job("1", {}).error().code, ErrorCode::NotFound);
}

TEST(JobIds, LastIsTheNewestJobOfItsOwner) {
    std::vector<JobStatus> jobs(3);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        jobs[i].job = JobId{i + 1};
        jobs[i].turn.owner = i == 2 ? "uri" : "ilan";
    }
    EXPECT_EQ(find_job("last", jobs, "ilan").value(), JobId{2});
    EXPECT_EQ(find_job("last", jobs, "uri").value(), JobId{3});
    EXPECT_EQ(find_job("last", jobs, "eve").error().code, ErrorCode::NotFound);
    EXPECT_EQ(find_job("1", jobs, "uri").value(), JobId{1}) << "others may be named";
}

} // namespace
} // namespace cd::tests
