// Proves that a job with [bodies] and [shots] becomes the scenarios of its lines, that rules take
// bodies and parts from the lines, and that mistakes end with their line.
#include "client/bundle/scene_lines.hpp"

#include "client/commands/commands.hpp"
#include "client/job/job_text.hpp"
#include "client/job/prepared_job.hpp"
#include "client/job/submission.hpp"
#include "client/scene/prepared_scene.hpp"
#include "client/scene/scene_check.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "g base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
constexpr const char* grid = "[shots]\nspacing = 0.25\ntile = 4\nazimuth_deg = [0, 90, 2]\n";

class SceneLinesTest : public testing::Test {
  protected:
    SceneLinesTest() {
        write_text(folder_ / "car.obj", pyramid);
        write_text(folder_ / "poses.csv",
                   "step,body,x,t\n0,car.0,0,0.5\n0,car.1,4,0.5\n"
                   "1,car.0,1,1\n1,car.1,nan,1\n");
    }

    [[nodiscard]] std::filesystem::path write(const std::string& rest,
                                              const std::string& name = "wall") const {
        write_text(folder_ / "job.toml",
                   "[bodies]\ncar = { mesh = \"car.obj\", group = \"traffic\", count = 2 }\n" +
                       name +
                       " = { mesh = \"car.obj\", pose = [2, 0.5, 0, 0, 0, 0, 1], quat_order = "
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
    [[nodiscard]] std::string problem(const std::string& rest,
                                      const std::string& name = "wall") const {
        const auto spec = read_job_file(write(rest, name));
        if (!spec) {
            EXPECT_EQ(spec.error().code, ErrorCode::BadInput);
            return spec.error().detail;
        }
        const auto made = prepare_scene(spec.value(), true);
        EXPECT_TRUE(made || made.error().code == ErrorCode::BadInput);
        return made ? "none" : made.error().detail;
    }

    TemporaryFolder folder_;
};

} // namespace

TEST_F(SceneLinesTest, BodiesAreTestedAgainstTheLinesAlone) {
    const PreparedScene scene = prepared(grid);
    ASSERT_TRUE(scene.lines);
    EXPECT_EQ(scene.scene.bodies.size(), 3u);
    EXPECT_EQ(scene.are_fixed, (std::vector<bool>{false, false, true, false}));
    EXPECT_EQ(scene.lines->mesh->triangles().size(), 16u);
    ASSERT_TRUE(scene.lines->spec.box);
    EXPECT_EQ(scene.lines->spec.box->max, Vec3(5, 1.5, 1)) << "all bodies at all steps";
    EXPECT_EQ(scene.steps->steps(), 2u);
    EXPECT_EQ(scene.steps->time_of(1), 1);
    const auto scenarios = scene.poses->read(0, scene.poses->count()).value();
    std::set<std::uint32_t> bodies;
    for (const Scenario& scenario : scenarios) {
        EXPECT_EQ(scenario.body_b, 3u);
        bodies.insert(scenario.body_a);
    }
    EXPECT_EQ(bodies, (std::set<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(scene.steps->coverage()[1].absent, scene.lines->bundles);
    EXPECT_EQ(scene.facts.absences, (std::vector<std::uint64_t>{0, 1, 0}));
}

TEST_F(SceneLinesTest, RulesTakeBodiesAndPartsFromTheLines) {
    const std::string rules = "[rules]\norder = [{ ignore = [\"group:traffic\", \"lines\"] },\n"
                              "{ test = [\"car.0\", \"lines\"] },\n"
                              "{ ignore = [\"wall/base\", \"*\"] }]\n";
    const PreparedScene scene = prepared(grid + rules);
    EXPECT_EQ(scene.ignored_pairs, 1u) << "car.1";
    EXPECT_EQ(scene.ignored, (std::vector<IgnoredRange>{{0, 1, 0, 16, 2, 3}}));
    EXPECT_EQ(scene.lines->spec.box->max, Vec3(3, 1.5, 1)) << "car.1 needs no lines";
    const auto scenarios = scene.poses->read(0, scene.poses->count()).value();
    EXPECT_TRUE(std::ranges::none_of(scenarios, [](const Scenario& s) { return s.body_a == 1; }));
    EXPECT_NE(scene.head, prepared(grid).head);
}

TEST_F(SceneLinesTest, TheCheckCountsLinesAndScenarios) {
    const auto spec = read_job_file(
        write(std::string(grid) + "[rules]\norder = [{ ignore = [\"car.1\", \"lines\"] }]\n"));
    ASSERT_TRUE(spec);
    const auto scene = prepare_scene(spec.value(), true);
    ASSERT_TRUE(scene);
    const std::string bundles = std::to_string(scene.value().lines->bundles);
    EXPECT_THAT(
        check_text(spec.value(), scene.value()),
        AllOf(HasSubstr("bodies: 3 of 1 mesh\n"),
              HasSubstr("lines: 2 azimuths, 1 elevation, " + bundles + " bundles of 16 lines\n"),
              HasSubstr("rules: lines pass by 1 of 3 bodies\n"),
              HasSubstr("2 steps, " + std::to_string(scene.value().poses->count()) +
                        " scenarios, each of a body and a bundle:\n"),
              HasSubstr("absent: car.1 at 1 step\n")));
    CheckCommand check;
    check.file = (folder_ / "job.toml").string();
    check.quiet = true;
    EXPECT_EQ(execute(check), 0);
}

TEST_F(SceneLinesTest, RulesCountOnlyPairsWithTheLines) {
    const auto spec =
        read_job_file(write(std::string(grid) + "[rules]\norder = [{ test = [\"*\", \"*\"] },\n"
                                                "{ ignore = [\"*\", \"car.1\"] },\n"
                                                "{ ignore = [\"wall/base\", \"*\"] }]\n"));
    ASSERT_TRUE(spec);
    const auto scene = prepare_scene(spec.value(), true);
    ASSERT_TRUE(scene) << scene.error().detail;
    EXPECT_EQ(scene.value().ignored_pairs, 1u);
    EXPECT_THAT(check_text(spec.value(), scene.value()),
                AllOf(HasSubstr(" tests 2 of the 3 pairs of bodies that it names\n"),
                      HasSubstr(" ignores 1 of the 1 pair of bodies that it names\n"),
                      HasSubstr(" ignores parts of 1 of the 1 pair of bodies that it names\n")));
}

TEST_F(SceneLinesTest, ABoxReplacesThatOfTheBodies) {
    const PreparedScene scene =
        prepared(std::string(grid) + "box = [-8, -8, -8, 8, 8, 8]\n[query]\nlevel = \"count\"\n");
    EXPECT_EQ(scene.lines->spec.box->min, Vec3(-8, -8, -8));
    EXPECT_GT(scene.lines->bundles, prepared(grid).lines->bundles);
    EXPECT_LE(scene.steps->coverage()[0].tested, 2u * 3u * 4u)
        << "from a direction, a body of side 1 meets at most four bundles of side 1";
}

TEST_F(SceneLinesTest, APreparedJobHasTheLinesAsItsLastBody) {
    auto spec = read_job_file(write(grid));
    ASSERT_TRUE(spec);
    TreeCache cache{std::filesystem::path()};
    ThreadPool pool(1);
    const auto job = prepare_job(std::move(spec.value()), Trees::Always, cache, pool);
    ASSERT_TRUE(job) << job.error().detail;
    EXPECT_EQ(job.value().names, (std::vector<std::string>{"car.0", "car.1", "wall", "lines"}));
    EXPECT_EQ(job.value().trees[3]->mesh().triangles().size(), 16u);
    EXPECT_EQ(job.value().query.question, Question::Shots);
    const ExportContext context = export_context(job.value());
    ASSERT_TRUE(context.bodies[3].views);
    EXPECT_FALSE(context.bodies[1].views);
    EXPECT_EQ(context.bodies[3].views->count(), 2u);
    const Submit submit = submission_of(job.value());
    EXPECT_EQ(submit.poses.kind, PosesKind::File);
    EXPECT_FALSE(submit.poses.shots) << "the text of the job has the lines";
    EXPECT_EQ(submit.bodies.size(), 4u);
    EXPECT_EQ(submit.bodies[3].name, "lines");
    EXPECT_EQ(submit.bodies[3].file, "");
    const auto again = spec_of(submit);
    ASSERT_TRUE(again) << again.error().detail;
    ASSERT_TRUE(again.value().scene->shots);
    EXPECT_EQ(job_text(again.value()), job_text(job.value().spec));
    EXPECT_THAT(job_text(again.value()), HasSubstr("box = ["));
    const auto views = views_of(again.value(), *job.value().meshes[0]);
    EXPECT_EQ(views->bundles(), context.bodies[3].views->bundles());
}

TEST_F(SceneLinesTest, MistakesEndWithTheirLine) {
    const std::string lines(grid);
    EXPECT_THAT(problem(lines + "[rules]\norder = [{ ignore = [\"cra.0\", \"lines\"] }]\n"),
                AllOf(HasSubstr("job.toml:12: [rules]"), HasSubstr("\"cra.0\" names no body")));
    EXPECT_THAT(
        problem(lines + "[rules]\norder = [{ ignore = [\"car.0\", \"wall\"] }]\n"),
        AllOf(HasSubstr("job.toml:12: [rules]"), HasSubstr("tested against \"lines\" alone")));
    EXPECT_THAT(problem(lines + "[rules]\norder = [{ ignore = [\"*\", \"lines\"] }]\n"),
                HasSubstr("job.toml: [rules] ignore every body with \"lines\""));
    EXPECT_THAT(problem(lines + "[rules]\nlearn = 0\n"), HasSubstr("leave out learn"));
    EXPECT_THAT(problem(lines, "lines"),
                HasSubstr("job.toml:3: [bodies] lines: \"lines\" is the name of the lines"));
    EXPECT_THAT(problem(lines + "box = [0, 0, 0, 1, -1, 1]\n"),
                HasSubstr("job.toml:11: [shots]: box has the low corner first"));
    EXPECT_THAT(problem(lines + "box = [0, 0, 0]\n"), HasSubstr("job.toml:11: [shots]:"));
    EXPECT_THAT(problem(lines + "[motion]\nresolution = 1\n"), HasSubstr("do not move"));
    EXPECT_THAT(problem(lines + "[query]\nlevel = \"count\"\nmaps = true\n"),
                HasSubstr("leave out maps"));
    EXPECT_THAT(problem(lines + "[query]\nclearance = 1\n"), HasSubstr("leave out clearance"));
    EXPECT_THAT(problem("[shots]\nspacing = 1e-9\n"), HasSubstr("job.toml:7: [shots]: "));
    CheckCommand check;
    check.file = write(lines + "[rules]\norder = [{ ignore = [\"cra.0\", \"lines\"] }]\n").string();
    EXPECT_EQ(execute(check), 2);
}

} // namespace cd::tests
