// Proves that lists are readable for people and exact for programs, and that the status names what
// delays the cluster.

#include "web/status/cluster_report.hpp"

#include "web/status/job_id.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

Table make_table() {
    Table table;
    table.columns = {{"thing", "THING", CellKind::Text},
                     {"count", "COUNT", CellKind::Count},
                     {"bytes", "BYTES", CellKind::Size},
                     {"hidden", "HIDDEN", CellKind::Seconds, true}};
    table.rows = {{std::string("a,\"b\""), std::uint64_t{1'234'567}, std::uint64_t{1536}, 0.125},
                  {std::string("long name"), std::uint64_t{7}, std::uint64_t{0}, 2.0}};
    return table;
}

TEST(TableForms, TextIsAlignedAndHidesTheWide) {
    EXPECT_EQ(format_table(make_table(), "text"),
              "THING          COUNT    BYTES\n"
              "a,\"b\"      1 234 567  1.5 KiB\n"
              "long name          7      0 B\n");
    EXPECT_THAT(format_table(make_table(), "wide"), HasSubstr("HIDDEN"));
}

TEST(TableForms, CsvAndJsonGiveAllAsItIs) {
    EXPECT_EQ(format_table(make_table(), "csv"),
              "thing,count,bytes,hidden\n"
              "\"a,\"\"b\"\"\",1234567,1536,0.125\n"
              "long name,7,0,2\n");
    const auto json = nlohmann::json::parse(format_table(make_table(), "json"));
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["thing"], "a,\"b\"");
    EXPECT_EQ(json[0]["count"], 1'234'567);
    EXPECT_EQ(json[0]["hidden"], 0.125);
    EXPECT_EQ(format_table(make_table(), "name"), "a,\"b\"\nlong name\n");
}

TEST(TableForms, NamesCannotSteerATerminalOrBreakJson) {
    Table table;
    table.columns = {{"thing", "THING", CellKind::Text}};
    table.rows = {{std::string("\x1b[2Jx\n\xff")}};
    EXPECT_THAT(format_table(table, "text"), HasSubstr("?[2Jx?"));
    EXPECT_TRUE(nlohmann::json::accept(format_table(table, "json")));
}

class Status : public testing::Test {
  protected:
    Status() {
        before_.build = "1.2";
        before_.uptime_seconds = 10;
        before_.cpu_seconds = 1;
        JobStatus job;
        job.job = JobId{1};
        job.name = "van";
        job.summary.total = 100;
        before_.jobs = {job};
        before_.workers.resize(2);
        for (WorkerStatus& worker : before_.workers) {
            worker.working = 20;
            worker.scenarios = 100;
        }
        before_.workers[1].worker = WorkerId{7};
        after_ = before_;
        after_.uptime_seconds = 11;
        after_.cpu_seconds = 1.1;
        for (WorkerStatus& worker : after_.workers) {
            worker.scenarios = 600;
        }
    }
    std::string bottleneck() const { return bottleneck_text(before_, after_); }

    ClusterStatus before_;
    ClusterStatus after_;
};

TEST_F(Status, NamesTheWorkersWhereTheyAreBusy) {
    EXPECT_THAT(bottleneck(), HasSubstr("workers' processors: 2 of 2 workers"));
    EXPECT_THAT(bottleneck(), HasSubstr("10 % of a core"));
}

TEST_F(Status, NamesTheMasterWhereItIsBusyAndTheWorkersAreNot) {
    after_.cpu_seconds = 2.5;
    for (WorkerStatus& worker : after_.workers) {
        worker.working = 0;
    }
    EXPECT_THAT(bottleneck(), HasSubstr("the master's processor (150 %"));
}

TEST_F(Status, SaysWhereThereIsTooLittleToDo) {
    for (WorkerStatus& worker : after_.workers) {
        worker.working = 0;
    }
    EXPECT_THAT(bottleneck(), HasSubstr("too little to do: 2 of 2"));
    after_.workers.clear();
    EXPECT_THAT(bottleneck(), HasSubstr("no worker"));
    after_.jobs[0].state = JobState::Done;
    EXPECT_THAT(bottleneck(), HasSubstr("none"));
}

TEST_F(Status, CountsTheMeshesThatNoJobNeeds) {
    after_.meshes.resize(3);
    for (MeshStatus& mesh : after_.meshes) {
        mesh.bytes = 1u << 20;
        mesh.is_needed = true;
    }
    EXPECT_THAT(status_text(before_, after_), HasSubstr("3 meshes   3.0 MiB\n"));
    after_.meshes[1].is_needed = false;
    EXPECT_THAT(status_text(before_, after_),
                HasSubstr("3 meshes   3.0 MiB   1 of no job (1.0 MiB): `cdctl rm MESH` removes"));
    EXPECT_EQ(nlohmann::json::parse(status_json(before_, after_))["meshes"][1]["needed"], "no");
}

TEST_F(Status, TheJobsTellTheCellsOfMotionsAndTheRootsOfDistances) {
    before_.jobs[0].statistics.search.effort = {1041, 521, 12, 3};
    const auto job = nlohmann::json::parse(format_table(jobs_table(before_), "json"))[0];
    EXPECT_EQ(job["cells"], 1041);
    EXPECT_EQ(job["leaves"], 521);
    EXPECT_EQ(job["roots_named"], 12);
    EXPECT_EQ(job["roots_used"], 3);
}

TEST_F(Status, NamesGeometryOnItsWay) {
    for (WorkerStatus& worker : after_.workers) {
        worker.scenarios = 100;
        worker.subtree_bytes_sent = 1u << 20;
    }
    EXPECT_THAT(bottleneck(), HasSubstr("geometry"));
    EXPECT_THAT(bottleneck(), HasSubstr("2.0 MiB/s"));
}

TEST_F(Status, AJobTellsItsPriorityAndShare) {
    after_.jobs[0].turn.priority = -7;
    after_.jobs[0].turn.share = 0.25;
    const Table table = jobs_table(after_);
    EXPECT_THAT(format_table(table, "text"), HasSubstr("PRIO"));
    EXPECT_THAT(format_table(table, "text"), testing::ContainsRegex("-7 +25 %"));
    EXPECT_THAT(format_table(table, "csv"), HasSubstr(",-7,0.25,"));
    const auto json = nlohmann::json::parse(format_table(table, "json"));
    EXPECT_EQ(json[0]["priority"], -7);
    EXPECT_EQ(json[0]["share"], 0.25);
}

TEST_F(Status, SaysHowMuchMoreWorkersWouldHelp) {
    EXPECT_THAT(status_text(before_, after_), Not(HasSubstr("more workers")));
    EXPECT_TRUE(nlohmann::json::parse(status_json(before_, after_))["more_workers"].is_null());
    after_.growth = Growth{160, {{1, 150}, {2, 140}}, {40, 100}};
    EXPECT_THAT(status_text(before_, after_),
                HasSubstr("\nmore workers: 40 more: 1.6 times as fast (100 s left instead of "
                          "160 s)\nbottleneck: "));
    const auto json = nlohmann::json::parse(status_json(before_, after_))["more_workers"];
    EXPECT_EQ(json["seconds"], 160);
    EXPECT_EQ(json["worth"]["workers"], 40);
    EXPECT_EQ(json["worth"]["times"], 1.6);
    ASSERT_EQ(json["more"].size(), 2u);
    EXPECT_EQ(json["more"][1]["workers"], 2);
    EXPECT_EQ(json["more"][1]["seconds"], 140);
    after_.growth->worth = {0, 160};
    EXPECT_THAT(status_text(before_, after_),
                HasSubstr("more workers: none would be used well; 160 s are left, with 1 more "
                          "150 s\n"));
}

TEST_F(Status, EndsWithTheBottleneck) {
    const std::string text = status_text(before_, after_);
    EXPECT_THAT(text, HasSubstr("1000/s"));
    EXPECT_THAT(text, HasSubstr("w-7"));
    EXPECT_THAT(text, HasSubstr("van"));
    const auto last = text.rfind('\n', text.size() - 2) + 1;
    EXPECT_EQ(text.substr(last), "bottleneck: " + bottleneck() + "\n");
    const auto json = nlohmann::json::parse(status_json(before_, after_));
    EXPECT_EQ(json["workers"].size(), 2u);
    EXPECT_EQ(json["bottleneck"], bottleneck());
}

TEST_F(Status, TellsOfLostWorkersLongScenariosWithdrawnResultsAndAlarms) {
    EXPECT_EQ(status_text(before_, after_).find("lost"), std::string::npos);
    after_.workers[1].state = WorkerState::Lost;
    after_.workers[1].working = 0;
    after_.workers[0].state = WorkerState::Silent;
    after_.losses.workers_lost = 1;
    after_.losses.scenarios_given_back = 40;
    after_.losses.sessions_resumed = 3;
    after_.alarms = {"results differ"};
    after_.alarm_count = 25;
    after_.jobs[0].long_scenarios = {{17, WorkerId{7}, "node-7", 75}};
    after_.jobs[0].withdrawn = 5;
    after_.jobs[0].recalled = 6;
    after_.jobs[0].copies = 8;
    after_.jobs[0].copies_won = 7;
    const std::string text = status_text(before_, after_);
    EXPECT_THAT(text, HasSubstr("silent"));
    EXPECT_THAT(text, HasSubstr("workers lost: 1   scenarios given to others: 40"));
    EXPECT_THAT(text, HasSubstr("ALARM: results differ"));
    const std::string id = job_id_text(JobId{1});
    EXPECT_THAT(text, HasSubstr("scenario 17 of " + id + " runs for"));
    EXPECT_THAT(text, HasSubstr("w-7 (node-7); `cdctl cancel " + id + " --scenario 17` ends it"));
    EXPECT_THAT(text, HasSubstr("5 results of " + id + " came from a worker in quarantine"));
    EXPECT_THAT(text,
                HasSubstr("at the end of " + id +
                          " 6 scenarios called back from workers that had "
                          "not begun them, 8 copied; of the copies, 7 ended first"));
    EXPECT_THAT(bottleneck(), HasSubstr("1 of 1 worker")) << "a lost one is not here";
    const auto json = nlohmann::json::parse(status_json(before_, after_));
    EXPECT_EQ(json["workers_lost"], 1);
    EXPECT_EQ(json["scenarios_given_back"], 40);
    EXPECT_EQ(json["sessions_resumed"], 3);
    EXPECT_EQ(json["alarm_count"], 25);
    EXPECT_EQ(json["long_scenarios"][0]["scenario"], 17);
    EXPECT_EQ(json["long_scenarios"][0]["name"], "node-7");
    EXPECT_EQ(json["jobs"][0]["withdrawn"], 5);
    EXPECT_EQ(json["jobs"][0]["recalled"], 6);
    EXPECT_EQ(json["jobs"][0]["copies"], 8);
    EXPECT_EQ(json["jobs"][0]["copies_won"], 7);
}

TEST_F(Status, OneJobIsOneObject) {
    const auto json = nlohmann::json::parse(job_json(before_.jobs[0]));
    EXPECT_EQ(json["name"], "van");
    EXPECT_EQ(json["scenarios"], 100);
    EXPECT_EQ(json["depths"], nlohmann::json::array()) << "not known yet";
}

TEST_F(Status, AJobTellsHowManyScenariosAndPairsAreNear) {
    before_.jobs[0].summary.near = 8;
    before_.jobs[0].summary.near_pairs = 900;
    before_.jobs[0].summary.touch = 1;
    const auto json = nlohmann::json::parse(job_json(before_.jobs[0]));
    EXPECT_EQ(json["near"], 8);
    EXPECT_EQ(json["near_pairs"], 900);
    EXPECT_EQ(json["contact"], 1);
}

TEST_F(Status, AJobTellsWhatTravelledForIt) {
    before_.jobs[0].traffic = {{1, 2, 3, 4, 5, 6}, 7};
    before_.jobs[0].depths = {8, 6};
    const auto json = nlohmann::json::parse(job_json(before_.jobs[0]));
    EXPECT_EQ(json["cache_hits"], 1);
    EXPECT_EQ(json["cache_misses"], 2);
    EXPECT_EQ(json["hinted"], 3);
    EXPECT_EQ(json["evictions"], 4);
    EXPECT_EQ(json["master_bytes"], 5);
    EXPECT_EQ(json["peer_bytes"], 6);
    EXPECT_EQ(json["result_bytes"], 7);
    EXPECT_EQ(json["depths"], (std::vector<int>{8, 6}));
    EXPECT_THAT(format_table(jobs_table(before_), "csv"), HasSubstr(",8 6,"));
}

} // namespace
} // namespace cd::tests
