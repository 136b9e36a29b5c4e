// Proves that one client has at most its share of connections, jobs and bytes, that shares are
// freed, and that one client's use does not count for another.
#include "master/net/quotas.hpp"

#include "common/core/limits/master.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

const Quotas::Time start{};

using Scenarios = std::optional<std::uint64_t>;

Scenarios all_run(JobId /*job*/) {
    return 1;
}

TEST(Quotas, ConnectionsAreCountedByClientAndComeBack) {
    Quotas quotas({.connections = 2}, all_run);
    EXPECT_TRUE(quotas.connect("ann"));
    EXPECT_TRUE(quotas.connect("ann"));
    const Status third = quotas.connect("ann");
    EXPECT_EQ(third.error().code, ErrorCode::Refused);
    EXPECT_THAT(third.error().detail, testing::HasSubstr("2 connections"));
    EXPECT_TRUE(quotas.connect("bob"));
    quotas.disconnect("ann");
    EXPECT_TRUE(quotas.connect("ann"));
    quotas.disconnect("nobody");
    EXPECT_FALSE(quotas.connect("ann"));
}

TEST(Quotas, OnlyJobsThatRunOrAreBeingOpenedCount) {
    bool first_runs = true;
    Quotas quotas({.jobs = 2}, [&](JobId job) {
        return job != JobId{1} || first_runs ? Scenarios(1) : std::nullopt;
    });
    EXPECT_TRUE(quotas.begin_job("ann", 1));
    EXPECT_TRUE(quotas.begin_job("ann", 1));
    EXPECT_FALSE(quotas.begin_job("ann", 1)) << "they wait for the disk, and count";
    quotas.give_up_job("ann", 1);
    EXPECT_TRUE(quotas.begin_job("ann", 1));
    quotas.add_job("ann", JobId{1}, {1, 0});
    quotas.add_job("ann", JobId{2}, {1, 0});
    const Status third = quotas.begin_job("ann", 1);
    EXPECT_EQ(third.error().code, ErrorCode::Refused);
    EXPECT_EQ(third.error().detail,
              "busy: quota: ann has 2 jobs running, of 2 that it may; retry after 30 s");
    EXPECT_TRUE(quotas.begin_job("bob", 1));
    first_runs = false;
    EXPECT_TRUE(quotas.begin_job("ann", 1));
}

TEST(Quotas, CountedBytesDecayAndARefusalNamesTheWait) {
    Quotas quotas({.bytes = 1000, .period = 100s}, all_run);
    EXPECT_TRUE(quotas.take_bytes("ann", 1000, start));
    const Status more = quotas.take_bytes("ann", 95, start);
    EXPECT_EQ(more.error().code, ErrorCode::Refused);
    EXPECT_THAT(more.error().detail, testing::HasSubstr("retry after 10 s"));
    EXPECT_TRUE(quotas.take_bytes("bob", 1000, start));
    // The rate is ten a second; refused bytes do not count.
    EXPECT_FALSE(quotas.take_bytes("ann", 101, start + 10s));
    EXPECT_TRUE(quotas.take_bytes("ann", 100, start + 10s));
    EXPECT_FALSE(quotas.take_bytes("ann", 1, start + 10s));
    EXPECT_TRUE(quotas.take_bytes("ann", 1000, start + 1000s));
}

TEST(Quotas, QueuedBytesCountUntilTheirJobEnds) {
    bool runs = true;
    Quotas quotas({.queued = 100},
                  [&](JobId /*job*/) { return runs ? Scenarios(1) : std::nullopt; });
    EXPECT_TRUE(quotas.queue("ann", 60));
    EXPECT_TRUE(quotas.begin_job("ann", 1));
    quotas.add_job("ann", JobId{1}, {1, 60});
    EXPECT_TRUE(quotas.queue("ann", 40));
    const Status more = quotas.queue("ann", 1);
    EXPECT_EQ(more.error().code, ErrorCode::Refused);
    EXPECT_THAT(more.error().detail, testing::HasSubstr("101 bytes of poses not yet done, of 100"));
    EXPECT_TRUE(quotas.queue("bob", 100));
    quotas.unqueue("ann", 40);
    EXPECT_TRUE(quotas.queue("ann", 1));
    EXPECT_FALSE(quotas.queue("ann", 40));
    runs = false;
    EXPECT_TRUE(quotas.queue("ann", 99));
    EXPECT_FALSE(quotas.queue("ann", 1));
    EXPECT_FALSE(quotas.queue("carl", ~0ull));
}

TEST(Quotas, OneClientBeginsOnlyItsShareOfUploads) {
    Quotas quotas({.uploads = 1}, all_run);
    EXPECT_TRUE(quotas.begin_upload("ann"));
    EXPECT_EQ(quotas.begin_upload("ann").error().code, ErrorCode::Refused);
    EXPECT_TRUE(quotas.begin_upload("bob"));
    quotas.end_upload("ann");
    EXPECT_TRUE(quotas.begin_upload("ann"));
}

TEST(Quotas, ScenariosCountFromTheBeginningOfAJobToItsEnd) {
    bool runs = true;
    Quotas quotas({.scenarios = 100}, [&](JobId job) {
        return job != JobId{1} || runs ? Scenarios(60) : std::nullopt;
    });
    EXPECT_TRUE(quotas.begin_job("ann", 60));
    const Status more = quotas.begin_job("ann", 41);
    EXPECT_EQ(more.error().code, ErrorCode::Refused);
    EXPECT_THAT(more.error().detail, testing::HasSubstr("101 scenarios of jobs, of 100"));
    EXPECT_FALSE(quotas.begin_job("ann", ~0ull));
    EXPECT_TRUE(quotas.begin_job("bob", 100));
    quotas.add_job("ann", JobId{1}, {60, 0});
    EXPECT_TRUE(quotas.begin_job("ann", 40));
    EXPECT_FALSE(quotas.begin_job("ann", 1));
    quotas.give_up_job("ann", 40);
    EXPECT_FALSE(quotas.begin_job("ann", 41));

    Quotas after({.scenarios = 100}, [](JobId) { return Scenarios(60); });
    after.restore_jobs(quotas.jobs_text());
    EXPECT_FALSE(after.begin_job("ann", 41));
    EXPECT_TRUE(after.begin_job("ann", 40));

    runs = false;
    EXPECT_TRUE(quotas.begin_job("ann", 100));
}

TEST(Quotas, JobsThatRunAreCountedAfterARestart) {
    Quotas before({}, all_run);
    for (const std::uint64_t job : {3u, 4u, 5u}) {
        const std::string client = job == 5 ? "bob with a blank" : "ann";
        EXPECT_TRUE(before.queue(client, 10 * job));
        EXPECT_TRUE(before.begin_job(client, 1));
        before.add_job(client, JobId{job}, {1, 10 * job});
    }
    Quotas after({.jobs = 1, .queued = 50},
                 [](JobId job) { return job != JobId{3} ? Scenarios(1) : std::nullopt; });
    after.restore_jobs(before.jobs_text() + "rubbish\n\n7\n");
    EXPECT_FALSE(after.begin_job("ann", 1));
    EXPECT_FALSE(after.begin_job("bob with a blank", 1));
    EXPECT_TRUE(after.begin_job("carl", 1));
    EXPECT_FALSE(after.queue("ann", 11));
    EXPECT_TRUE(after.queue("ann", 10));
    EXPECT_FALSE(after.queue("bob with a blank", 1));
}

TEST(Quotas, ClientsThatHaveLeftAreForgotten) {
    Quotas quotas({}, all_run);
    for (std::size_t i = 0; i < 2 * limits::connections_max + 2; ++i) {
        const std::string name = std::to_string(i);
        EXPECT_TRUE(quotas.connect(name));
        quotas.disconnect(name);
    }
    EXPECT_LE(quotas.clients(), limits::connections_max);
}

} // namespace
} // namespace cd::tests
