// Proves that a job with [bodies] becomes the scenarios of its steps, from its files alone, and
// that `cdctl job check` says what is tested and by which rules.
#include "client/scene/prepared_scene.hpp"

#include "client/commands/commands.hpp"
#include "client/scene/coverage_text.hpp"
#include "client/scene/scene_check.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A tetrahedron at the origin, of size 1.
constexpr const char* pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "g base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

class PreparedSceneTest : public testing::Test {
  protected:
    PreparedSceneTest() {
        write_text(folder_ / "car.obj", pyramid);
        write_text(folder_ / "wall.obj", pyramid);
        write_text(folder_ / "poses.csv",
                   "step,body,x,t\n0,car.0,0,0.5\n0,car.1,1,0.5\n0,car.2,9,0.5\n"
                   "1,car.0,5,1\n1,car.1,5.5,1\n1,car.2,nan,1\n");
    }

    [[nodiscard]] std::filesystem::path write(const std::string& rest) const {
        write_text(folder_ / "job.toml",
                   "[bodies]\ncar = { mesh = \"car.obj\", group = \"traffic\", count = 3 }\n"
                   "wall = { mesh = \"wall.obj\", pose = [0, 0.5, 0, 0, 0, 0, 1], quat_order = "
                   "\"xyzw\" }\n[poses]\nfile = \"poses.csv\"\nabsent = \"nan\"\n" +
                       rest);
        return folder_ / "job.toml";
    }
    [[nodiscard]] PreparedScene prepared(const std::string& rest) const {
        const auto spec = read_job_file(write(rest));
        EXPECT_TRUE(spec) << spec.error().detail;
        auto made = prepare_scene(spec.value(), true);
        EXPECT_TRUE(made) << made.error().detail;
        return std::move(made.value());
    }
    [[nodiscard]] static std::vector<BodyPair> pairs_of(const PreparedScene& scene) {
        std::vector<BodyPair> pairs;
        const auto scenarios = scene.poses->read(0, scene.poses->count());
        EXPECT_TRUE(scenarios);
        for (const Scenario& scenario : scenarios.value()) {
            pairs.push_back({scenario.body_a, scenario.body_b});
        }
        return pairs;
    }

    TemporaryFolder folder_;
};

} // namespace

TEST_F(PreparedSceneTest, HasTheScenariosOfItsSteps) {
    const PreparedScene scene = prepared("");
    EXPECT_EQ(scene.scene.bodies.size(), 4u);
    EXPECT_EQ(scene.scene.meshes.size(), 2u);
    // Step 0: the cars 0 and 1 touch at x = 1, and the wall overlaps both. Step 1: two cars.
    EXPECT_EQ(pairs_of(scene), (std::vector<BodyPair>{{0, 1}, {0, 3}, {1, 3}, {0, 1}}));
    EXPECT_EQ(scene.steps->coverage()[0], (StepCoverage{3, 3, 0, 0, 0}));
    EXPECT_EQ(scene.steps->coverage()[1], (StepCoverage{1, 2, 0, 0, 3}));
    EXPECT_EQ(scene.steps->time_of(1), 1);
    EXPECT_EQ(scene.facts.zeros, (std::vector<std::string>{"y", "z", "roll", "pitch", "yaw"}));
}

TEST_F(PreparedSceneTest, RulesTakeScenariosAndPartsAway) {
    const PreparedScene scene =
        prepared("[rules]\norder = [{ ignore = [\"group:traffic\", \"group:traffic\"] },\n"
                 "{ ignore = [\"car.*/base\", \"wall\"] }]\n");
    EXPECT_EQ(pairs_of(scene), (std::vector<BodyPair>{{0, 3}, {1, 3}}));
    EXPECT_EQ(scene.ignored_pairs, 3u);
    ASSERT_EQ(scene.ignored.size(), 3u);
    EXPECT_EQ(scene.ignored[1], (IgnoredRange{0, 1, 0, 4, 1, 3}));
    EXPECT_EQ(scene.steps->coverage()[0], (StepCoverage{2, 1, 3, 0, 0}));
}

TEST_F(PreparedSceneTest, AClearanceReachesFarther) {
    EXPECT_EQ(prepared("[query]\nclearance = 3\n").poses->count(), 4u);
    EXPECT_EQ(prepared("[query]\nclearance = 7\n").steps->coverage()[0].tested, 4u);
    EXPECT_EQ(prepared("[query]\nlevel = \"distance\"\nup_to = 8.5\n").steps->coverage()[0].tested,
              6u);
}

TEST_F(PreparedSceneTest, NamesDoNotMatterToThePairs) {
    const auto pairs = pairs_of(prepared(""));
    write_text(folder_ / "other.toml",
               "[bodies]\nzebra = { mesh = \"car.obj\", count = 3 }\n"
               "ant = { mesh = \"wall.obj\", pose = [0, 0.5, 0, 0, 0, 0, 1], quat_order = "
               "\"xyzw\" }\n[poses]\nfile = \"other.csv\"\nabsent = \"nan\"\n");
    write_text(folder_ / "other.csv",
               "step,body,x\n0,zebra.0,0\n0,zebra.1,1\n0,zebra.2,9\n"
               "1,zebra.0,5\n1,zebra.1,5.5\n1,zebra.2,nan\n");
    const auto spec = read_job_file(folder_ / "other.toml");
    ASSERT_TRUE(spec);
    const auto renamed = prepare_scene(spec.value(), true);
    ASSERT_TRUE(renamed) << renamed.error().detail;
    EXPECT_EQ(pairs_of(renamed.value()), pairs);
}

TEST_F(PreparedSceneTest, TheCheckSaysWhatIsTestedAndByWhichRules) {
    const std::string rules =
        "[rules]\norder = [{ ignore = [\"*\", \"*\"] },\n{ test = [\"car.*\", \"wall\"] },\n"
        "{ ignore = [\"car.1/base\", \"wall\"] }]\n";
    const auto spec = read_job_file(write(rules));
    ASSERT_TRUE(spec);
    const auto scene = prepare_scene(spec.value(), true);
    ASSERT_TRUE(scene);
    EXPECT_EQ(
        check_text(spec.value(), scene.value()),
        "bodies: 4 of 2 meshes\n"
        "  car: 3 bodies, car.obj, 4 triangles each, group traffic\n"
        "  wall: wall.obj, 4 triangles\n"
        "rules: of 6 pairs of bodies 3 are ignored, and of others 1 range of pairs of "
        "triangles\n"
        "  line 8: { ignore = [\"*\", \"*\"] } ignores 3 of the 6 pairs of bodies that it "
        "names\n"
        "  line 9: { test = [\"car.*\", \"wall\"] } tests 3 of the 3 pairs of bodies that it "
        "names\n"
        "  line 10: { ignore = [\"car.1/base\", \"wall\"] } ignores parts of 1 of the 1 pair of "
        "bodies that it names\n"
        "2 steps, 2 scenarios:\n"
        "  2 of 12 pairs tested, 3 apart by their boxes, 4 ignored, 3 of an absent body\n"
        "  most at step 0: 2 of 6 pairs tested, 1 apart by their boxes, 3 ignored\n"
        "  absent: car.2 at 1 step\n");
    EXPECT_EQ(coverage_csv(*scene.value().steps),
              "step,time,tested,apart,ignored,fixed,absent\n0,0.5,2,1,3,0,0\n1,1,0,2,1,0,3\n");
}

TEST_F(PreparedSceneTest, ErrorsNameTheLineAndEndWithCodeTwo) {
    const auto problem = [&](const std::string& rest) {
        const auto spec = read_job_file(write(rest));
        EXPECT_TRUE(spec);
        const auto made = prepare_scene(spec.value(), true);
        return made ? "none" : made.error().detail;
    };
    EXPECT_THAT(problem("[rules]\norder = [{ ignore = [\"cra.*\", \"wall\"] }]\n"),
                AllOf(HasSubstr("job.toml:8: [rules]"), HasSubstr("\"cra.*\" names no body")));
    EXPECT_THAT(problem("[rules]\nlearn = 2\n"),
                HasSubstr(": [rules] learn = 2: the steps are 0 to 1"));
    CheckCommand check;
    check.file = write("[rules]\norder = [{ ignore = [\"cra.*\", \"wall\"] }]\n").string();
    EXPECT_EQ(execute(check), 2);
    check.file = write("").string();
    check.quiet = true;
    EXPECT_EQ(execute(check), 0);
    write_text(folder_ / "two.toml",
               "[a]\nmesh = \"car.obj\"\n[b]\nmesh = \"wall.obj\"\n[poses]\nrandom = { n = 1 }\n");
    check.file = (folder_ / "two.toml").string();
    const auto two = perform(check);
    ASSERT_FALSE(two);
    EXPECT_THAT(two.error().detail, HasSubstr("--dry-run` checks it"));
}

TEST_F(PreparedSceneTest, TheCheckWarnsOfALargeClearance) {
    const auto said = [&](const std::string& query) {
        CheckCommand check;
        check.file = write(query).string();
        check.quiet = true;
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        EXPECT_EQ(execute(check), 0);
        static_cast<void>(testing::internal::GetCapturedStdout());
        return testing::internal::GetCapturedStderr();
    };
    EXPECT_THAT(said("[query]\nclearance = 50\nlevel = \"contacts\"\n"),
                HasSubstr("warning: the clearance of 50 m exceeds most triangles of car.0"));
    EXPECT_EQ(said("[query]\nclearance = 50\nlevel = \"count\"\n"), "");
    EXPECT_EQ(said("[query]\nclearance = 0.001\n"), "");
}

TEST_F(PreparedSceneTest, FilesThatAreReadAlikeAreOneMesh) {
    write_text(folder_ / "job.toml",
               "[bodies]\na = { mesh = \"car.obj\" }\nb = { mesh = \"car.obj\" }\n"
               "c = { mesh = \"car.obj\", unit = \"mm\" }\n[poses]\nfile = \"p.csv\"\n");
    write_text(folder_ / "p.csv", "step,body,x\n0,a,0\n0,b,1\n0,c,2\n");
    const auto spec = read_job_file(folder_ / "job.toml");
    ASSERT_TRUE(spec);
    const auto made = prepare_scene(spec.value(), true);
    ASSERT_TRUE(made) << made.error().detail;
    EXPECT_EQ(made.value().scene.meshes.size(), 2u);
    EXPECT_EQ(made.value().scene.bodies[0].mesh, made.value().scene.bodies[1].mesh);
}

} // namespace cd::tests
