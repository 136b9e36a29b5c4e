// Proves, with real processes, that groups at level count are those of a run that lists pairs: of a
// local run, and of a job on a master though a worker is killed; and that reports, diffs, baselines
// and reuse have them.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/parts.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Rows of groups.csv by their parts, without class, regions and episodes, which sums do not know.
std::map<std::string, std::vector<std::string>> known_columns(const std::string& csv) {
    std::map<std::string, std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream fields(line);
        for (std::string cell; std::getline(fields, cell, ',');) {
            cells.push_back(cell);
        }
        EXPECT_GE(cells.size(), 15u) << line;
        std::vector<std::string>& kept = rows[cells[1] + " x " + cells[3]];
        for (const std::size_t column : {5u, 6u, 7u, 8u, 9u, 13u, 14u}) {
            kept.push_back(cells[column]);
        }
    }
    return rows;
}

class Groups : public Cluster {
  protected:
    Groups() {
        write_obj(folder_ / "a.obj", in_parts(make_torus(1, 0.4, 60, 30), 6));
        write_obj(folder_ / "b.obj", in_parts(make_sphere(3), 3));
        write_job(40);
    }

    void write_job(int count, const std::string& x_max = "2.5") {
        const std::string n = std::to_string(count);
        write_text(folder_ / "job.toml",
                   "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\n"
                   "grid = { x = [-2.5, " +
                       x_max + ", " + n + "], yaw_deg = [0, 350, " + n + "] }\n");
    }
    [[nodiscard]] std::vector<std::string> words(const std::string& out,
                                                 std::vector<std::string> more) {
        std::vector<std::string> all{cdctl(), "run", folder_ / "job.toml", "--out", folder_ / out};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    [[nodiscard]] Ran run_into(const std::string& out, std::vector<std::string> more) {
        return tests::run(words(out, std::move(more)));
    }
    [[nodiscard]] Ran ask(std::vector<std::string> more) {
        more.insert(more.begin(), cdctl());
        more.insert(more.end(), {"--master", master_->address()});
        return tests::run(more);
    }
    [[nodiscard]] std::string groups_of(const std::string& out) {
        return read_text(folder_ / out / "groups.csv");
    }
    [[nodiscard]] nlohmann::json summary_of(const std::string& out) {
        return nlohmann::json::parse(read_text(folder_ / out / "summary.json"));
    }

    const std::vector<std::string> counts_{"--level", "count", "--maps"};
};

} // namespace

TEST_F(Groups, OfAJobWhoseWorkerIsKilledAreThoseOfALocalRunThatListsPairs) {
    ASSERT_EQ(run_into("pairs", {"--level", "pairs"}).exit_code, 0);
    const auto expected = known_columns(groups_of("pairs"));
    ASSERT_GT(expected.size(), 10u);
    const Ran counted = run_into("counted", counts_);
    ASSERT_EQ(counted.exit_code, 0) << counted.errors;
    EXPECT_EQ(known_columns(groups_of("counted")), expected);
    EXPECT_THAT(counted.output, HasSubstr("  most touched  part "));
    EXPECT_EQ(summary_of("counted")["most_touched"], summary_of("pairs")["most_touched"]);

    start_worker();
    Process& victim = start_worker();
    std::vector<std::string> at_master = counts_;
    at_master.insert(at_master.end(), {"--master", master_->address()});
    Process run(words("job", at_master), folder_ / "run");
    ASSERT_TRUE(comes_true([&] {
        const auto status = connection_->status();
        return status && !status.value().jobs.empty() &&
               status.value().jobs[0].summary.merged() >
                   status.value().jobs[0].answered_by_master + 50;
    })) << run.errors();
    victim.signal(SIGKILL);
    ASSERT_EQ(run.wait(), 0) << run.errors();
    EXPECT_EQ(groups_of("job"), groups_of("counted"));
    EXPECT_EQ(summary_of("job")["most_touched"], summary_of("pairs")["most_touched"]);

    ASSERT_EQ(ask({"results", "last", "--out", folder_ / "fetched"}).exit_code, 0);
    EXPECT_EQ(groups_of("fetched"), groups_of("counted"));
    const Ran reported = ask({"report", "last", "-o", folder_ / "report" / "report.html"});
    ASSERT_EQ(reported.exit_code, 0) << reported.errors;
    EXPECT_EQ(groups_of("report"), groups_of("counted"));
    EXPECT_THAT(read_text(folder_ / "report" / "report.html"), HasSubstr("<h2>Groups</h2>"));

    const Ran same = ask({"diff", folder_ / "pairs", "last", "-o", "json", "--fail-on", "new"});
    ASSERT_EQ(same.exit_code, 0) << same.errors;
    const auto groups = nlohmann::json::parse(same.output)["groups"];
    EXPECT_EQ(groups.size(), expected.size() - 1) << "less the head";
    for (const auto& group : groups) {
        EXPECT_EQ(group["state"], "unchanged");
    }
}

TEST_F(Groups, OfACountAreJudgedByABaselineAndReused) {
    start_worker(2);
    std::vector<std::string> at_master = counts_;
    at_master.insert(at_master.end(), {"--master", master_->address()});
    ASSERT_EQ(run_into("old", at_master).exit_code, 0);
    std::vector<std::string> judged = counts_;
    judged.insert(judged.end(), {"--baseline", folder_ / "old", "--fail-on", "new"});
    const Ran same = run_into("same", judged);
    EXPECT_EQ(same.exit_code, 0) << same.errors;
    EXPECT_THAT(same.output, HasSubstr("new 0, active "));

    write_job(3, "-2.2"); // On one side of A, few parts are in contact.
    ASSERT_EQ(run_into("few", counts_).exit_code, 0);
    write_job(79); // Every second position is one of the old ones.
    judged = counts_;
    judged.insert(judged.end(), {"--baseline", folder_ / "few", "--fail-on", "new"});
    const Ran news = run_into("whole", judged);
    EXPECT_EQ(news.exit_code, 1) << news.errors;
    EXPECT_THAT(news.output, HasSubstr("  new           part "));
    const Ran changed = tests::run({cdctl(), "diff", folder_ / "old", folder_ / "whole"});
    EXPECT_EQ(changed.exit_code, 0) << changed.errors;
    EXPECT_THAT(changed.output, HasSubstr(" not comparable"));

    for (const bool is_local : {true, false}) {
        std::vector<std::string> reusing = is_local ? counts_ : at_master;
        reusing.insert(reusing.end(), {"--reuse", folder_ / "old"});
        const std::string name = is_local ? "here" : "there";
        const Ran reused = run_into(name, reusing);
        ASSERT_EQ(reused.exit_code, 0) << reused.errors;
        EXPECT_THAT(reused.output, HasSubstr("  reused "));
        EXPECT_EQ(groups_of(name), groups_of("whole"));
        EXPECT_EQ(summary_of(name)["most_touched"], summary_of("whole")["most_touched"]);
    }
    const Ran without = run_into("plain", {"--level", "count", "--formats", "csv"});
    EXPECT_EQ(without.exit_code, 0) << without.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "plain" / "groups.csv"));
    const Ran refused =
        tests::run({cdctl(), "report", folder_ / "plain", "--baseline", folder_ / "old"});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("or level count with maps = true"));
}

} // namespace cd::tests
