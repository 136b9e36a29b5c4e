// Proves that a job file gives shot lines in the place of body B and its poses, that what does not
// go together with them is refused where it stands, and that the text of a job reads the same.
#include "client/spec/shots_spec.hpp"

#include "client/job/job_text.hpp"
#include "client/job/submission.hpp"
#include "client/spec/job_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Makes a job whose table [shots] begins in line 3.
std::string job_with(const std::string& shots, const std::string& more = "") {
    return "[a]\nmesh = \"a.obj\"\n[shots]\n" + shots + more;
}

Result<JobSpec> read(const std::string& shots, const std::string& more = "") {
    return parse_job(job_with(shots, more), "folder/job.toml");
}

ShotsSpec shots_of(const Result<JobSpec>& spec) {
    return spec ? std::get<ShotsSpec>(spec.value().poses) : ShotsSpec{};
}

std::string problem_with(const std::string& shots, const std::string& more = "") {
    const auto spec = read(shots, more);
    if (spec) {
        return "none";
    }
    EXPECT_EQ(spec.error().code, ErrorCode::BadInput);
    return spec.error().detail;
}

const std::string grid = "spacing = 0.5\n";

} // namespace

TEST(ShotsSpec, IsAGridFromSomeDirections) {
    const auto spec = read("spacing = 0.5\ntile = 16\noffset = [0.25, 0.75]\nfirst = true\n"
                           "azimuth_deg = [0, 270, 4]\nelevation_deg = [-30, 90, 3]\n",
                           "[query]\nlevel = \"count\"\nmaps = true\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().query.question, Question::Shots);
    EXPECT_EQ(spec.value().query.level, Level::Count);
    EXPECT_TRUE(spec.value().query.first_hits);
    EXPECT_TRUE(spec.value().query.maps);
    EXPECT_EQ(query_problem(spec.value().query), nullptr);
    EXPECT_EQ(export_name(spec.value(), 1), "lines");
    const ShotsSpec shots = shots_of(spec);
    EXPECT_EQ(shots.grid.spacing, 0.5);
    EXPECT_EQ(shots.grid.tile, 16u);
    EXPECT_EQ(shots.grid.offset, (std::array<double, 2>{0.25, 0.75}));
    EXPECT_FALSE(shots.grid.jitter_seed);
    const std::vector<ShotView> views = shots.views();
    ASSERT_EQ(views.size(), 12u);
    EXPECT_EQ(views[1], (ShotView{90, -30}));
    EXPECT_EQ(views[11], (ShotView{270, 90}));
}

TEST(ShotsSpec, HasLevelPairsAndOneDirectionByDefault) {
    const auto spec = read(grid);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().query.level, Level::Pairs);
    EXPECT_FALSE(spec.value().query.first_hits);
    EXPECT_EQ(shots_of(spec).views(), std::vector<ShotView>(1));
    EXPECT_EQ(shots_of(spec).grid.tile, 64u);
    EXPECT_EQ(shots_of(read(grid + "jitter = { seed = 7 }\n")).grid.jitter_seed, 7u);
}

TEST(ShotsSpec, MayBeAFileBesideTheJob) {
    const auto spec = read("file = \"rays.npy\"\nform = \"rays\"\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(shots_of(spec).file, "folder/rays.npy");
    EXPECT_EQ(shots_of(spec).form, LineForm::Rays);
    EXPECT_EQ(shots_of(read("file = \"rays.npy\"\n")).form, LineForm::Ends);
    EXPECT_THAT(problem_with("file = \"rays.npy\"\nspacing = 1\n"),
                HasSubstr("job.toml:5: [shots]: spacing belongs to a grid"));
    EXPECT_THAT(problem_with(grid + "form = \"rays\"\n"),
                HasSubstr("job.toml:5: [shots]: form belongs to lines from a file"));
    EXPECT_THAT(problem_with("file = \"rays.npy\"\nform = \"end\"\n"), HasSubstr("job.toml:5:"));
    EXPECT_THAT(problem_with("file = \"\"\n"), HasSubstr("job.toml:4: [shots]: file is empty"));
}

TEST(ShotsSpec, TakesThePlaceOfBodyBAndOfThePoses) {
    EXPECT_THAT(problem_with(grid, "[b]\nmesh = \"b.obj\"\n"),
                HasSubstr("job.toml:5: the job: [shots] takes the place of [b] and [poses]"));
    EXPECT_THAT(problem_with(grid, "[poses]\nrandom = { n = 1 }\n"),
                HasSubstr("job.toml:5: the job: [shots] takes the place of [b] and [poses]"));
    const auto named =
        parse_job("[a]\nmesh = \"a.obj\"\nname = \"lines\"\n[shots]\n" + grid, "folder/job.toml");
    EXPECT_THAT(named.error().detail, HasSubstr("job.toml:1: the job: both bodies have the name"));
}

TEST(ShotsSpec, NumbersAreInRange) {
    EXPECT_THAT(problem_with("tile = 8\n"), HasSubstr("job.toml:3: [shots]: spacing"));
    EXPECT_THAT(problem_with("spacing = 0\n"), HasSubstr("job.toml:4: [shots]: spacing"));
    EXPECT_THAT(problem_with("spacing = inf\n"), HasSubstr("job.toml:4: [shots]:"));
    EXPECT_THAT(problem_with("spacing = 1e308\n"), HasSubstr("too large"));
    EXPECT_THAT(problem_with(grid + "tile = 0\n"), HasSubstr("job.toml:5: [shots]: tile"));
    EXPECT_THAT(problem_with(grid + "offset = [0.5, 1.5]\n"), HasSubstr("job.toml:5:"));
    EXPECT_THAT(problem_with(grid + "offset = [0.5]\n"), HasSubstr("job.toml:5:"));
    EXPECT_THAT(problem_with(grid + "offset = [0.5, 0.5]\njitter = { seed = 1 }\n"),
                HasSubstr("offset does not count with jitter"));
    EXPECT_THAT(problem_with(grid + "azimuth_deg = [0, 90, 0]\n"), HasSubstr("job.toml:5:"));
    EXPECT_THAT(problem_with(grid + "azimuth_deg = [0, 0, 2]\n"), HasSubstr("are equal"));
    EXPECT_THAT(problem_with(grid + "elevation_deg = [0, 91, 2]\n"), HasSubstr("-90 and 90"));
    EXPECT_THAT(problem_with(grid + "azimuth_deg = [0, 1, 100000]\nelevation_deg = [0, 1, "
                                    "100000]\n"),
                HasSubstr("directions"));
    EXPECT_THAT(problem_with(grid + "spaceing = 1\n"), HasSubstr("\"spacing\""));
}

TEST(ShotsSpec, IsNotAskedWithAClearanceOrAnotherLevel) {
    const auto problem = [](const std::string& query) {
        return problem_with(grid, "[query]\n" + query);
    };
    for (const std::string level : {"any", "contacts", "distance"}) {
        EXPECT_THAT(problem("level = \"" + level + "\"\n"),
                    HasSubstr("job.toml:6: [query]: lines of [shots] are asked at level count or "
                              "pairs"))
            << level;
    }
    EXPECT_THAT(problem("clearance = 1\n"), HasSubstr("job.toml:6: [query]: a line of [shots]"));
    EXPECT_THAT(problem("up_to = 1\n"), HasSubstr("job.toml:6: [query]: up_to belongs to"));
    EXPECT_EQ(problem("level = \"pairs\"\nlimit_pairs = 5\n"), "none");
}

TEST(ShotsSpec, CanBeReadFromTheTextOfTheJob) {
    for (const std::string shots :
         {"spacing = 0.5\ntile = 16\noffset = [0.25, 0.75]\nazimuth_deg = [0, 270, 4]\n",
          "spacing = 2\njitter = { seed = 5 }\nelevation_deg = [90, 90, 1]\nfirst = true\n",
          "file = \"rays.npy\"\nform = \"rays\"\n",
          "file = \"rays.npy\"\n"}) {
        SCOPED_TRACE(shots);
        const auto spec = read(shots);
        ASSERT_TRUE(spec) << spec.error().detail;
        const std::string text = job_text(spec.value());
        const auto again = parse_job(text, "job.toml");
        ASSERT_TRUE(again) << again.error().detail << "\n" << text;
        EXPECT_EQ(job_text(again.value()), text);
        EXPECT_EQ(shots_of(again).views(), shots_of(spec).views());
        EXPECT_EQ(shots_of(again).grid.jitter_seed, shots_of(spec).grid.jitter_seed);
        EXPECT_EQ(shots_of(again).grid.offset, shots_of(spec).grid.offset);
        EXPECT_EQ(shots_of(again).form, shots_of(spec).form);
        EXPECT_EQ(again.value().query.first_hits, spec.value().query.first_hits);
        EXPECT_EQ(again.value().query.question, Question::Shots);
    }
}

} // namespace cd::tests
