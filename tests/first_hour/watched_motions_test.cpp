// Proves that `cdctl watch` names the same first contact of motions as `cdctl run` does.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class WatchedMotions : public testing::Test {
  protected:
    WatchedMotions() {
        write_obj(folder_ / "car.obj", make_box({1, 1, 1}));
        write_obj(folder_ / "post.obj", make_box({0.2, 0.2, 1}));
    }

    /// Writes a job with these bodies and poses, of motions.
    void write_job(const std::string& bodies, const std::string& poses) const {
        write_text(folder_ / "poses.csv", poses);
        write_text(folder_ / "job.toml",
                   "unit = \"m\"\n" + bodies +
                       "[poses]\nfile = \"poses.csv\"\n[motion]\nresolution = 0.01\n");
    }

    /// Runs cdctl with a word and the job's master or file.
    Ran type(const std::vector<std::string>& words) const {
        std::vector<std::string> all{cdctl()};
        all.insert(all.end(), words.begin(), words.end());
        return tests::run(all);
    }

    /// Returns what `cdctl run` here and `cdctl watch` on a master say of the first event.
    [[nodiscard]] std::pair<std::string, std::string> said() const {
        const MortalMaster master(folder_);
        const Process worker(
            {program("cdworker").string(), "--master", master.address(), "--threads", "1"},
            folder_ / "worker");
        const std::string job = folder_ / "job.toml";
        EXPECT_EQ(type({"submit", job, "--master", master.address()}).exit_code, 0);
        const Ran watched = type({"watch", "last", "--master", master.address()});
        EXPECT_EQ(watched.exit_code, 0) << watched.errors;
        return {line_of(type({"run", job}).output), line_of(watched.output)};
    }

    static std::string line_of(const std::string& output) {
        const std::size_t at = output.find("  first ");
        return at == output.npos ? "" : output.substr(at, output.find('\n', at) - at);
    }

    const TemporaryFolder folder_;
};

constexpr const char* two_bodies = "[a]\nmesh = \"car.obj\"\n[b]\nmesh = \"post.obj\"\n";

} // namespace

TEST_F(WatchedMotions, OfTwoBodiesHaveTheTimesOfTheirPoses) {
    write_job(two_bodies, "t,x\n10,9\n20,5\n40,0\n50,0\n");
    const auto [here, watched] = said();
    EXPECT_THAT(here, HasSubstr("first contact between t 3"))
        << "after t 20, some 18 of 20 s later";
    EXPECT_THAT(here, HasSubstr(" in scenario 1"));
    EXPECT_EQ(watched, here);
}

TEST_F(WatchedMotions, WithoutTimesCountTheirScenarios) {
    write_job(two_bodies, "x\n9\n5\n0\n0\n");
    const auto [here, watched] = said();
    EXPECT_THAT(here, HasSubstr("first contact between t 1."));
    EXPECT_EQ(watched, here);
}

TEST_F(WatchedMotions, OfASceneHaveTheTimesOfItsSteps) {
    write_job("[bodies]\ncar = { mesh = \"car.obj\", count = 2 }\n",
              "step,t,body,x\n0,5,car.0,0\n0,5,car.1,9\n1,6,car.0,0\n1,6,car.1,5\n"
              "2,8,car.0,0\n2,8,car.1,0\n");
    const auto [here, watched] = said();
    EXPECT_THAT(here, HasSubstr("first contact between t 7."));
    EXPECT_EQ(watched, here);
}

TEST_F(WatchedMotions, ThatStayFreeHaveNone) {
    write_job(two_bodies, "x\n9\n5\n");
    const auto [here, watched] = said();
    EXPECT_EQ(here, "");
    EXPECT_EQ(watched, "");
}

} // namespace cd::tests
