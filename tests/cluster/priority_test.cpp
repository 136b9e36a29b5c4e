// Proves, with real processes, that a job of higher priority overtakes one that runs, also after a
// restart of the master, and also if it got the priority later; that `cdctl` shows priorities,
// shares and what more workers would bring; and that a priority above 0 needs the role admin.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"
#include "web/status/job_id.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class Priority : public MortalCluster {
  protected:
    explicit Priority(Links links = Links::Plain) : MortalCluster({}, links) {
        write_obj(folder_ / "a.obj", make_sphere(4));
        write_obj(folder_ / "b.obj", make_torus(1, 0.4, 60, 30));
    }
    /// Writes a job of so many poses on a grid, and returns its path.
    std::string job_file(std::uint64_t poses) {
        const std::string path = folder_ / "job.toml";
        write_text(path,
                   "[a]\nmesh = \"a.obj\"\nunit = \"m\"\n[b]\nmesh = \"b.obj\"\nunit = \"m\"\n"
                   "[poses]\ngrid = { x = [0, 1, " +
                       std::to_string(poses) + "] }\n");
        return path;
    }
    Ran submit_by_cdctl(std::uint64_t poses, std::vector<std::string> options) {
        options.insert(options.begin(), {cdctl(), "submit", job_file(poses)});
        options.insert(options.end(), {"--master", master_.address(), "-o", "name"});
        return tests::run(options);
    }
    Ran set_by_cdctl(const std::string& job,
                     const std::string& priority,
                     const std::vector<std::string>& options = {}) {
        std::vector<std::string> words{
            cdctl(), "priority", job, priority, "--master", master_.address()};
        words.insert(words.end(), options.begin(), options.end());
        return tests::run(words);
    }
    [[nodiscard]] nlohmann::json list_jobs() {
        const Ran ran =
            tests::run({cdctl(), "get", "jobs", "-o", "json", "--master", master_.address()});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return nlohmann::json::parse(ran.output);
    }
    static JobId submit_ranked(Connection& connection, const Job& job, std::int32_t priority) {
        return submit_job(connection, job, Query{}, many_blocks(), priority);
    }
};

// Both jobs are alike, so in turns the first one, which runs already, would end first.
TEST_F(Priority, AJobOvertakesOneOfLowerPriority) {
    const Job job = make_job(12000);
    auto connection = connect();
    const JobId low = submit_ranked(*connection, job, -2);
    start_worker(2);
    (void)watch_until(*connection, low, 1);
    const JobId high = submit_ranked(*connection, job, 3);
    (void)watch_until(*connection, high, 3000);
    restart_master(connection);
    for (const JobId id : {high, low}) {
        const JobStatus ended = finish(*connection, id);
        EXPECT_EQ(ended.state, JobState::Done);
        EXPECT_EQ(ended.turn.priority, id == low ? -2 : 3);
        EXPECT_EQ(ended.digest, job.digest_in_one_process(Query{}));
    }
    const auto end_of = [&](JobId id) {
        return master_.log().find("job ended: job=" + std::to_string(id.value) + " ");
    };
    ASSERT_NE(end_of(low), std::string::npos);
    EXPECT_LT(end_of(high), end_of(low)) << master_.log();
}

// The second job, which waits, would end last.
TEST_F(Priority, AJobThatRunsGetsAnotherWhichARestartKeeps) {
    const Job job = make_job(12000);
    auto connection = connect();
    const JobId early = submit_ranked(*connection, job, 1);
    start_worker(2);
    (void)watch_until(*connection, early, 1);
    const JobId late = submit_ranked(*connection, job, 0);
    const Ran lowered = set_by_cdctl(job_id_text(early), "-6");
    EXPECT_EQ(lowered.exit_code, 0) << lowered.errors;
    EXPECT_EQ(lowered.output, job_id_text(early) + "  priority -6\n");
    EXPECT_EQ(set_by_cdctl(job_id_text(late), "2").exit_code, 0);
    restart_master(connection);
    for (const JobId id : {late, early}) {
        const JobStatus ended = finish(*connection, id);
        EXPECT_EQ(ended.turn.priority, id == early ? -6 : 2);
        EXPECT_EQ(ended.digest, job.digest_in_one_process(Query{}));
    }
    const auto end_of = [&](JobId id) {
        return master_.log().find("job ended: job=" + std::to_string(id.value) + " ");
    };
    ASSERT_NE(end_of(early), std::string::npos);
    EXPECT_LT(end_of(late), end_of(early)) << master_.log();
    const Ran refused = set_by_cdctl(job_id_text(late), "3");
    EXPECT_EQ(refused.exit_code, 5);
    EXPECT_THAT(refused.errors, HasSubstr("the job has ended"));
}

TEST_F(Priority, CdctlSubmitsAndShowsIt) {
    const Ran low = submit_by_cdctl(200'000, {"--priority", "-3"});
    ASSERT_EQ(low.exit_code, 0) << low.errors;
    const Ran high = submit_by_cdctl(500, {"--priority", "7"});
    ASSERT_EQ(high.exit_code, 0) << high.errors;
    for (const auto& job : list_jobs()) {
        EXPECT_EQ(job["priority"], low.output.starts_with(job["job"].get<std::string>()) ? -3 : 7);
        EXPECT_EQ(job["share"], 0);
    }
    start_worker(2);
    EXPECT_TRUE(comes_true([&] {
        const auto jobs = list_jobs();
        return jobs[1]["state"] == "done" && jobs[0]["share"] == 1;
    }));
    const Ran text = tests::run({cdctl(), "get", "jobs", "--master", master_.address()});
    EXPECT_THAT(text.output, HasSubstr("PRIO"));
    EXPECT_THAT(text.output, HasSubstr("SHARE"));
    const Ran status = tests::run({cdctl(), "status", "-o", "json", "--master", master_.address()});
    const auto more = nlohmann::json::parse(status.output)["more_workers"];
    ASSERT_TRUE(more.is_object()) << status.output;
    EXPECT_EQ(more["more"].size(), 11u);
    EXPECT_GE(more["more"][10]["times"], 1);
    EXPECT_GT(more["seconds"], 0);
    EXPECT_THAT(tests::run({cdctl(), "status", "--master", master_.address()}).output,
                HasSubstr("\nmore workers: "));
}

TEST_F(Priority, ARunOnTheMasterHasIt) {
    start_worker(2);
    const Ran ran = tests::run({cdctl(),
                                "run",
                                job_file(500),
                                "--master",
                                master_.address(),
                                "--priority",
                                "-4",
                                "--quiet"});
    EXPECT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_EQ(list_jobs()[0]["priority"], -4);
}

TEST_F(Priority, AWrongOneIsNamed) {
    const Ran ran = submit_by_cdctl(10, {"--priority", "11"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.errors, HasSubstr("--priority"));
    EXPECT_THAT(ran.errors, HasSubstr("10"));
    auto connection = connect();
    const Job job = make_job(10);
    Submit submit;
    submit.bodies = {{job.a->mesh().hash()}, {job.b->mesh().hash()}};
    submit.priority = -11;
    const auto poses = make_list_source(job.scenarios);
    const auto accepted = connection->submit(submit, *poses);
    ASSERT_FALSE(accepted);
    EXPECT_THAT(accepted.error().detail, HasSubstr("the priority is -11 and may be -10 to 10"));
}

class SecuredPriority : public Priority {
  protected:
    SecuredPriority() : Priority(Links::Secured) {}
};

TEST_F(SecuredPriority, AboveZeroNeedsTheRoleAdmin) {
    const auto authority =
        CertificateAuthority::parse(read_text(folder_ / "state/identity/authority.pem"),
                                    read_text(folder_ / "state/identity/authority.key"));
    const WallTime now = std::chrono::system_clock::now();
    const std::chrono::hours hour(1);
    const std::string ann = folder_ / "ann.pem";
    ASSERT_TRUE(write_credential(
        ann, authority.value().issue({CertifiedRole::Submitter, "ann", now - hour, now + hour})));
    const Ran refused = submit_by_cdctl(10, {"--priority", "1", "--credential", ann});
    EXPECT_EQ(refused.exit_code, 5) << refused.errors;
    EXPECT_THAT(refused.errors,
                HasSubstr("priority 1 needs the role admin, and 'ann' is a submitter"));
    const std::vector<std::string> by_ann{"--credential", ann};
    const std::vector<std::string> by_admin{"--credential", admin().string()};
    const auto submitted = [&](std::string priority, std::vector<std::string> options) {
        options.insert(options.end(), {"--priority", std::move(priority)});
        const Ran ran = submit_by_cdctl(10, options);
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return ran.output.substr(0, ran.output.find('\n'));
    };
    const std::string of_ann = submitted("-1", by_ann);
    const std::string of_admin = submitted("1", by_admin);

    EXPECT_EQ(set_by_cdctl(of_ann, "-2", by_ann).exit_code, 0);
    const Ran raised = set_by_cdctl(of_ann, "2", by_ann);
    EXPECT_EQ(raised.exit_code, 5);
    EXPECT_THAT(raised.errors, HasSubstr("priority 2 needs the role admin"));
    EXPECT_EQ(set_by_cdctl(of_ann, "2", by_admin).output, of_ann + "  priority 2\n");
    EXPECT_THAT(set_by_cdctl(of_admin, "-2", by_ann).errors, HasSubstr("the job belongs to"));
}

} // namespace
} // namespace cd::tests
