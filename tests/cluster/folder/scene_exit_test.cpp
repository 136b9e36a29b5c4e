// Proves, with real processes, with which exit codes commands about scenes end: 3 if a scenario
// failed, which every file and report tells, and 5 if the master refuses the job.
#include "proto/access/credential_file.hpp"
#include "tests/cluster/folder/cluster_folder.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Writes a scene of a ring that passes through a ball which stands, with these further tables.
void write_scene(const TemporaryFolder& folder, const std::string& tables) {
    write_obj(folder / "ring.obj", make_torus(1.0, 0.4, 24, 12));
    write_obj(folder / "ball.obj", make_sphere(2));
    write_text(folder / "poses.csv", "step,body,x\n0,ring,-3\n1,ring,1\n2,ring,1.5\n3,ring,4\n");
    write_text(folder / "job.toml",
               "[bodies]\nring = { mesh = \"ring.obj\" }\nball = { mesh = \"ball.obj\", pose = [0, "
               "0, 0, 0, 0, 0, 1], quat_order = \"xyzw\" }\n[poses]\nfile = \"poses.csv\"\n" +
                   tables);
}

class SceneExits : public ClusterFolder {
  protected:
    /// Runs a scene on the cluster, where the scenario with this number in words fails.
    void expect_3_of_a_failure(const std::string& tables, const std::string& scenario) {
        write_scene(folder_, tables);
        Process run({cdctl(),
                     "run",
                     folder_ / "job.toml",
                     "--out",
                     folder_ / "out",
                     "--formats",
                     "csv,npz,json",
                     "--fail-on",
                     "touch",
                     "--master",
                     master_->address()},
                    folder_ / "run");
        EXPECT_TRUE(comes_true([&] { return id_of_last_job().starts_with("j-"); }));
        EXPECT_TRUE(comes_true([&] {
            return cdctl_at_master({"cancel", "last", "--scenario", scenario}).exit_code == 0;
        })) << "without a worker, it has no answer";
        start_worker();
        EXPECT_EQ(run.wait(), 3) << run.errors();
        EXPECT_EQ(cdctl_at_master({"wait", "last"}).exit_code, 3);
        EXPECT_EQ(cdctl_at_master({"results", "last", "-o", "csv"}).exit_code, 3);
        EXPECT_EQ(cdctl_here({"report", folder_ / "out", "-o", folder_ / "report.html"}).exit_code,
                  3);
        EXPECT_EQ(read_json("out", "summary.json")["failed"], 1);
        EXPECT_THAT(read("out", "scenarios.csv"),
                    testing::ContainsRegex("," + scenario + ",failed,[^\n]*cancelled"));
        EXPECT_THAT(read("out", "coverage.csv"), testing::ContainsRegex("[0-9],1\n"));
        EXPECT_THAT(read_text(folder_ / "report.html"),
                    testing::ContainsRegex("#" + scenario + ", step [0-9], ring[^<]*failed: "));
    }
};

class SecuredScene : public MortalCluster {
  protected:
    SecuredScene() : MortalCluster({}, Links::Secured) {}
};

} // namespace

TEST_F(SceneExits, Is3IfAScenarioFailed) {
    expect_3_of_a_failure("[query]\nlevel = \"pairs\"\n", "0");
}

TEST_F(SceneExits, Is3IfAMotionFailed) {
    expect_3_of_a_failure("[motion]\nresolution = 0.01\n", "1");
}

TEST_F(SceneExits, Is3IfABundleOfLinesFailed) {
    expect_3_of_a_failure("[shots]\nspacing = 0.25\ntile = 16\n", "2");
}

TEST_F(SecuredScene, IsRefusedWith5WhereASubmitterAsksForAHighPriority) {
    write_scene(folder_, "");
    const auto authority =
        CertificateAuthority::parse(read_text(folder_ / "state/identity/authority.pem"),
                                    read_text(folder_ / "state/identity/authority.key"));
    const WallTime now = std::chrono::system_clock::now();
    const std::chrono::hours hour(1);
    const std::string ann = folder_ / "ann.pem";
    ASSERT_TRUE(write_credential(
        ann, authority.value().issue({CertifiedRole::Submitter, "ann", now - hour, now + hour})));
    const Ran refused = tests::run({cdctl(),
                                    "run",
                                    folder_ / "job.toml",
                                    "--priority",
                                    "1",
                                    "--credential",
                                    ann,
                                    "--master",
                                    master_.address()});
    EXPECT_EQ(refused.exit_code, 5) << refused.errors;
    EXPECT_THAT(refused.errors, HasSubstr("priority 1 needs the role admin"));
}

TEST_F(SceneExits, Is5IfTheMasterRefusesToRemoveOrCancelWhatIsDone) {
    write_scene(folder_, "[query]\nlevel = \"pairs\"\n");
    ASSERT_EQ(cdctl_at_master({"submit", folder_ / "job.toml"}).exit_code, 0);
    EXPECT_EQ(cdctl_at_master({"rm", "last", "--yes"}).exit_code, 5) << "it is running";
    start_worker();
    EXPECT_EQ(cdctl_at_master({"wait", "last"}).exit_code, 0);
    EXPECT_EQ(cdctl_at_master({"cancel", "last", "--scenario", "0"}).exit_code, 5);
}

} // namespace cd::tests
