// Proves that a job file is interpreted as documented, and that every error in one is refused with
// line, key and remedy.
#include "client/spec/job_file.hpp"

#include "client/spec/job_options.hpp"
#include "common/core/limits/master.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr const char* good = R"(name = "van-bollard"
unit = "m"
[a]
mesh = "van.glb"
[b]
mesh = "/abs/bollard.stl"
unit = "mm"
name = "bollard"
precision = "float"
[poses]
file = "poses.npy"
quat_order = "wxyz"
of = "both"
rigid_tolerance = 1e-4
[query]
level = "contacts"
limit_pairs = 10_000
clearance = 5e-3
ignore = [["wheel_*", "ground"]]
[output]
dir = "results"
formats = ["json", "npz"]
[cluster]
strategy = "lowest"
analysis = "never"
depth = { a = 10, b = 4 }
q = 7
v_kb = 64
claim = true
)";

const std::string minimal = "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n";

Result<JobSpec> parse(const std::string& text) {
    return parse_job(text, "folder/job.toml");
}

/// Returns the error of a document that starts with the two bodies (4 lines).
std::string problem_with(const std::string& rest) {
    const auto spec = parse(minimal + rest);
    return spec ? "none" : spec.error().detail;
}

const std::string random_poses = "[poses]\nrandom = { n = 10 }\n";

} // namespace

TEST(JobFile, TwoBodiesOfOneNameAreRefused) {
    const auto problem_of_names = [](const std::string& a, const std::string& b) {
        const auto spec =
            parse("[a]\nmesh = \"a.obj\"\n" + a + "[b]\nmesh = \"b.obj\"\n" + b + random_poses);
        return spec ? "none" : spec.error().detail;
    };
    EXPECT_EQ(
        problem_of_names("name = \"x\"\n", "name = \"x\"\n"),
        "folder/job.toml:4: the job: both bodies have the name \"x\"; exports need two names");
    EXPECT_EQ(
        problem_of_names("name = \"b\"\n", ""),
        "folder/job.toml:4: the job: both bodies have the name \"b\"; exports need two names");
    EXPECT_EQ(problem_of_names("name = \"b\"\n", "name = \"a\"\n"), "none");
}

TEST(JobFile, ABodyHasTheOriginThatIsGiven) {
    const std::string bodies = "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\norigin = ";
    const auto spec = parse(bodies + "[0.5, -1, 2]\n" + random_poses);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().bodies[0].origin, (std::array{0.0, 0.0, 0.0}));
    EXPECT_EQ(spec.value().bodies[1].origin, (std::array{0.5, -1.0, 2.0}));
    EXPECT_THAT(parse(bodies + "[1, 2]\n" + random_poses).error().detail,
                HasSubstr("job.toml:5: [b]: \"origin\" has to be [x, y, z]"));
}

TEST(JobFile, EveryKeyIsRead) {
    const auto spec = parse(good);
    ASSERT_TRUE(spec) << spec.error().detail;
    const JobSpec& job = spec.value();
    EXPECT_EQ(job.name, "van-bollard");
    EXPECT_EQ(job.bodies[0].path, "folder/van.glb");
    EXPECT_EQ(job.bodies[0].unit, "");
    EXPECT_EQ(job.bodies[1].path, "/abs/bollard.stl");
    EXPECT_EQ(job.bodies[1].unit, "mm");
    EXPECT_EQ(job.bodies[1].name, "bollard");
    EXPECT_FALSE(job.bodies[0].rounds_to_float);
    EXPECT_TRUE(job.bodies[1].rounds_to_float);
    const auto& poses = std::get<PoseFileSpec>(job.poses);
    EXPECT_EQ(poses.path, "folder/poses.npy");
    EXPECT_EQ(poses.quat_order, "wxyz");
    EXPECT_TRUE(poses.of_both_bodies);
    EXPECT_EQ(poses.rigid_tolerance, 1e-4);
    EXPECT_EQ(job.query.level, Level::Contacts);
    EXPECT_EQ(job.query.limit_pairs, 10'000u);
    EXPECT_EQ(job.query.clearance, 0.005);
    ASSERT_EQ(job.ignore.size(), 1u);
    EXPECT_EQ(job.ignore[0].a, "wheel_*");
    EXPECT_EQ(job.ignore[0].b, "ground");
    EXPECT_EQ(job.ignore[0].line, 19u);
    EXPECT_EQ(job.output.dir, "folder/results");
    EXPECT_EQ(job.output.formats, (std::vector<std::string>{"json", "npz"}));
    EXPECT_EQ(job.cluster.strategy, "lowest");
    EXPECT_EQ(job.cluster.analysis, AnalysisMode::Never);
    EXPECT_EQ(job.cluster.depth(0), 10u);
    EXPECT_EQ(job.cluster.depth(1), 4u);
    EXPECT_EQ(job.cluster.q, 7u);
    EXPECT_EQ(job.cluster.v_kb, 64u);
    EXPECT_TRUE(job.cluster.claim);
}

TEST(JobFile, WhatIsLeftOutHasADefault) {
    const auto spec = parse(minimal + random_poses);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().name, "job");
    EXPECT_EQ(spec.value().query.level, Level::Pairs);
    EXPECT_FALSE(spec.value().query.clearance);
    EXPECT_TRUE(spec.value().output.dir.empty());
    const auto& random = std::get<RandomPoses>(spec.value().poses);
    EXPECT_EQ(random.count, 10u);
    EXPECT_EQ(random.penetration_min, 0.005);
}

TEST(JobFile, AGridIsTheProductOfItsAxes) {
    const auto spec =
        parse(minimal + "[poses]\ngrid = { x = [-3, 3, 200], yaw_deg = [0, 350, 36] }\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    const Grid& grid = std::get<GridSpec>(spec.value().poses).grid;
    EXPECT_EQ(grid.count(), 200u * 36u);
    EXPECT_EQ(grid.position[0].last, 3.0);
    EXPECT_EQ(grid.rotation[2].size(), 36u);
}

TEST(JobFile, PosesMayHaveAUnitOfTheirOwn) {
    const auto file = parse(minimal + "[poses]\nfile = \"p.csv\"\nunit = \"mm\"\n");
    ASSERT_TRUE(file) << file.error().detail;
    EXPECT_EQ(std::get<PoseFileSpec>(file.value().poses).length_factor, 0.001);
    const auto grid =
        parse("unit = \"cm\"\n" + minimal +
              "[poses]\nunit = \"m\"\ngrid = { x = [-1, 2, 4], yaw_deg = [0, 90, 2] }\n");
    ASSERT_TRUE(grid) << grid.error().detail;
    const auto& spec = std::get<GridSpec>(grid.value().poses);
    EXPECT_EQ(spec.grid.position[0], (GridAxis{-100, 200, 4}));
    EXPECT_EQ(spec.axes[0], (GridAxis{-1, 2, 4})) << "as the job says it";
    EXPECT_EQ(spec.unit, "m");
    EXPECT_THAT(
        problem_with("[poses]\nunit = \"mm\"\nrandom = { n = 10 }\n"),
        HasSubstr("job.toml:6: [poses]: unit belongs to poses from a file, a grid or a curve"));
}

TEST(JobFile, UnknownKeysNameTheLineAndTheNearestKey) {
    EXPECT_EQ(problem_with(random_poses + "[query]\nlevle = \"any\"\n"),
              "folder/job.toml:8: [query] has no key \"levle\"; did you mean \"level\"?");
    EXPECT_THAT(problem_with(random_poses + "[ouput]\n"), HasSubstr("did you mean \"output\"?"));
    EXPECT_THAT(problem_with("[poses]\nrandom = { count = 3 }\n"), HasSubstr(":6: [poses] random"));
}

TEST(JobFile, WrongTypesNameTheLine) {
    EXPECT_THAT(problem_with(random_poses + "[query]\nlevel = 3\n"),
                HasSubstr(":8: [query]: \"level\" has to be text"));
    EXPECT_THAT(problem_with(random_poses + "[cluster]\nclaim = 1\n"),
                HasSubstr(":8: [cluster]: \"claim\" has to be true or false"));
    EXPECT_THAT(problem_with(random_poses + "[cluster]\nq = 2.5\n"), HasSubstr("a whole number"));
    EXPECT_THAT(problem_with(random_poses + "output = 3\n"), HasSubstr(":7:"));
    EXPECT_THAT(problem_with("[poses]\ngrid = { x = [0, 1] }\n"),
                HasSubstr("[first, last, count]"));
    EXPECT_THAT(problem_with("[poses]\ngrid = { x = [0, nan, 3] }\n"),
                HasSubstr("[first, last, count]"));
}

TEST(JobFile, ValuesOutOfRangeAreRefused) {
    EXPECT_THAT(problem_with("[poses]\nrandom = { n = 0 }\n"), HasSubstr("n = 0 is not between"));
    EXPECT_THAT(problem_with("[poses]\nrandom = { n = -5 }\n"), HasSubstr("n = -5 is not between"));
    EXPECT_THAT(problem_with("[poses]\nrandom = { n = 5, penetration = [0.2, 0.1] }\n"),
                HasSubstr("least <= most"));
    EXPECT_THAT(problem_with("[poses]\ngrid = { x = [0, 1, 0] }\n"), HasSubstr("at least 1"));
    EXPECT_THAT(problem_with("[poses]\ngrid = { x = [0, 1, 9e11], y = [0, 1, 9e11] }\n"),
                HasSubstr("poses"));
    EXPECT_THAT(problem_with(random_poses + "[cluster]\ndepth = { a = 99 }\n"),
                HasSubstr("a = 99"));
    for (const char* axis : {"x = [-1.7e308, 1.7e308, 3]", "yaw_deg = [-1.7e308, 1.7e308, 3]"}) {
        EXPECT_THAT(problem_with("[poses]\ngrid = { " + std::string(axis) + " }\n"),
                    HasSubstr("job.toml:6: [poses] grid: "));
    }
    EXPECT_THAT(problem_with("[poses]\nunit = \"km\"\ngrid = { z = [0, 1e306, 2] }\n"),
                HasSubstr("z is too long"));
}

TEST(JobFile, AClearanceIsALengthOfAtLeastZero) {
    const std::string query = random_poses + "[query]\nclearance = ";
    for (const char* length : {"0", "0.0", "1", "2.5", "1e300"}) {
        EXPECT_EQ(problem_with(query + length + "\n"), "none") << length;
    }
    for (const char* length : {"-0.001", "-1"}) {
        EXPECT_THAT(problem_with(query + length + "\n"),
                    HasSubstr(":8: [query]: clearance is a length of at least 0"))
            << length;
    }
    for (const char* length : {"nan", "inf", "\"1\"", "true"}) {
        EXPECT_THAT(problem_with(query + length + "\n"), HasSubstr(":8: [query]: \"clearance\""))
            << length;
    }
}

TEST(JobFile, UnknownWordsNameThoseThatExist) {
    EXPECT_THAT(problem_with(random_poses + "[query]\nlevel = \"contact\"\n"),
                HasSubstr("did you mean \"contacts\"?"));
    EXPECT_THAT(problem_with(random_poses + "[output]\nformats = [\"csv\", \"hdf\"]\n"),
                HasSubstr("format \"hdf\" is not known; this version has text, json, csv, "
                          "csv-pairs, npz, h5, vtp "
                          "and glb"));
    EXPECT_THAT(problem_with(random_poses + "[output]\nformats = [1]\n"),
                HasSubstr("text in quotes"));
    EXPECT_THAT(parse("unit = \"inch\"\n" + minimal + random_poses).error().detail,
                HasSubstr("did you mean \"in\"?"));
}

TEST(JobFile, AToleranceIsGone) {
    for (const char* value : {"0.1", "0.0", "\"0.1\""}) {
        EXPECT_THAT(
            problem_with(random_poses + "[query]\ntolerance = " + value + "\n"),
            testing::AllOf(HasSubstr(":8: the job: the key tolerance"),
                           HasSubstr("is gone, since exact answers are faster: remove it")));
    }
}

TEST(JobFile, ExactlyOneSourceOfPosesIsNeeded) {
    EXPECT_THAT(problem_with(""), HasSubstr("[poses] is missing"));
    EXPECT_THAT(problem_with("[poses]\n"), HasSubstr("exactly one of"));
    EXPECT_THAT(problem_with("[poses]\nfile = \"p.csv\"\nrandom = { n = 1 }\n"),
                HasSubstr("exactly one of"));
    EXPECT_THAT(problem_with(random_poses + "of = \"both\"\n"),
                HasSubstr("belongs to poses from a file"));
}

TEST(JobFile, AMissingBodyIsNamed) {
    EXPECT_THAT(parse("[a]\nmesh = \"a.obj\"\n" + random_poses).error().detail,
                HasSubstr("the table [b] with its mesh is missing"));
    EXPECT_THAT(parse("[a]\n[b]\nmesh = \"b.obj\"\n" + random_poses).error().detail,
                HasSubstr(":1: [a]: the key \"mesh\""));
}

TEST(JobFile, AnIgnoreRuleIsAPairOfNames) {
    EXPECT_THAT(problem_with(random_poses + "[query]\nignore = [[\"a\"]]\n"),
                HasSubstr("pairs of part names"));
    EXPECT_THAT(problem_with(random_poses + "[query]\nignore = [[\"a\", 1]]\n"),
                HasSubstr("pairs of part names"));
}

TEST(JobFile, ATextThatIsNoTomlNamesTheLine) {
    EXPECT_THAT(problem_with("[poses\n"), HasSubstr("folder/job.toml:5: "));
}

TEST(JobFile, AMissingFileIsNamed) {
    const auto spec = read_job_file("no/such/job.toml");
    ASSERT_FALSE(spec);
    EXPECT_EQ(spec.error().code, ErrorCode::NotFound);
    EXPECT_THAT(spec.error().detail, HasSubstr("no/such/job.toml"));
}

TEST(JobOptions, AJobNeedsNoFile) {
    JobOptions options;
    options.a = "cars/van.obj";
    options.b = "post.stl";
    options.unit_b = "mm";
    options.precision = "float";
    options.poses.random = 5;
    options.poses.seed = 9;
    options.poses.penetration = {0.01, 0.02};
    options.query.level = "count";
    options.output.dir = "here";
    const auto spec = make_job_spec(options);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().name, "van-post");
    EXPECT_EQ(spec.value().bodies[1].unit, "mm");
    EXPECT_TRUE(spec.value().bodies[0].rounds_to_float);
    EXPECT_TRUE(spec.value().bodies[1].rounds_to_float);
    EXPECT_EQ(spec.value().query.level, Level::Count);
    EXPECT_EQ(spec.value().output.dir, "here");
    const auto& random = std::get<RandomPoses>(spec.value().poses);
    EXPECT_EQ(random.count, 5u);
    EXPECT_EQ(random.seed, 9u);
    EXPECT_EQ(random.penetration_max, 0.02);
}

TEST(JobOptions, OptionsThatDoNotFitAreRefused) {
    JobOptions options;
    EXPECT_FALSE(make_job_spec(options));
    options.a = "a.obj";
    options.b = "b.obj";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("--poses"));
    options.poses.file = "p.csv";
    options.poses.seed = 3;
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("--random"));
    options.poses.seed.reset();
    options.poses.rigid_tolerance = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("--rigid-tolerance is a number"));
    options.poses.rigid_tolerance.reset();
    options.output.formats = {"hdf"};
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("npz, h5, vtp and glb"));
    options.output.formats = {"glb"};
    options.output.dir = "out";
    options.query.level = "any";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("format glb shows in how many"));
    options.query.level = "count";
    EXPECT_FALSE(make_job_spec(options));
    options.query.maps = true;
    EXPECT_TRUE(make_job_spec(options));
    options.file = "job.toml";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("names the meshes"));
}

TEST(JobOptions, AClearanceOverridesThatOfTheFile) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, minimal + random_poses + "[query]\nclearance = 0.25\n");
    EXPECT_EQ(make_job_spec(options).value().query.clearance, 0.25);
    options.query.clearance = 0.0;
    EXPECT_EQ(make_job_spec(options).value().query.clearance, 0.0);
    for (const double none : {-1.0, HUGE_VAL, std::nan("")}) {
        options.query.clearance = none;
        EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("--clearance is a finite"));
    }
}

TEST(JobFile, ABufferThatTheMasterRefusesIsRefusedHere) {
    const std::string cluster = random_poses + "[cluster]\nv_kb = ";
    EXPECT_EQ(problem_with(cluster + std::to_string(limits::v_kb_max)), "none");
    EXPECT_THAT(problem_with(cluster + std::to_string(limits::v_kb_max + 1)),
                HasSubstr(":8: [cluster]: v_kb = 16385 is not between 1 and 16384"));
}

TEST(JobFile, TheJobsOfTheDocumentsAreRead) {
    int jobs = 0;
    for (const char* page : {"README.md", "docs/job-file.md", "docs/scenes.md"}) {
        std::istringstream lines(read_text(std::filesystem::path(CD_SOURCE_DIR) / page));
        std::string line;
        while (std::getline(lines, line)) {
            if (line != "```toml") {
                continue;
            }
            std::string text;
            while (std::getline(lines, line) && line != "```") {
                text += line + "\n";
            }
            const auto job = parse(text);
            EXPECT_TRUE(job) << page << ": " << job.error().detail;
            ++jobs;
        }
    }
    EXPECT_EQ(jobs, 3);
}

TEST(JobFile, NamesOfFilesThatAreEmptyAreNamed) {
    EXPECT_EQ(problem_with("[poses]\nfile = \"\"\n"),
              "folder/job.toml:6: [poses]: file is empty; give the name of a file with poses");
    const auto mesh = parse("[a]\nmesh = \"\"\n[b]\nmesh = \"b.obj\"\n" + random_poses);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().detail,
              "folder/job.toml:2: [a]: the key \"mesh\" with the file's name is missing");
}

} // namespace cd::tests
