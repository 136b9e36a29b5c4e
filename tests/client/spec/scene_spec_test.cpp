// Proves that a job file's scene is interpreted as documented, and that every error in one names
// the line and what to write instead.
#include "client/spec/scene_spec.hpp"

#include "client/job/job_text.hpp"
#include "client/spec/job_file.hpp"
#include "client/spec/job_options.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr const char* good = R"(unit = "cm"
[bodies]
truck = { mesh = "truck.glb", group = "traffic", poses = "truck.csv", origin = [2.5, 0, -0.5] }
wall = { mesh = "/abs/wall.stl", unit = "mm", up = "y", pose = [1, 2, 3, 1, 0, 0, 0], quat_order = "wxyz" }
car = { mesh = "sedan.obj", group = "traffic", count = 500, precision = "float" }
[bodies.factory]
mesh = "factory.glb"
split = "parts"
[poses]
file = "poses.npy"
unit = "m"
quat_order = "xyzw"
rigid_tolerance = 1e-4
body_order = ["car.0", "car.1"]
absent = "nan"
[rules]
learn = 3
order = [ { ignore = ["group:traffic", "group:traffic"] },
          { test = ["car.1", "truck"] } ]
[query]
level = "count"
clearance = 0.5
)";

const std::string two = "[bodies]\na = { mesh = \"a.obj\" }\nb = { mesh = \"b.obj\" }\n";

Result<JobSpec> parse(const std::string& text) {
    return parse_job(text, "folder/job.toml");
}

std::string problem_of(const std::string& text) {
    const auto spec = parse(text);
    return spec ? "none" : spec.error().detail;
}

/// Returns the error of a body on line 2.
std::string problem_of_body(const std::string& keys) {
    return problem_of("[bodies]\ncar = { mesh = \"car.obj\", " + keys + " }\n");
}

/// Returns the error of rules that begin on line 4, behind two bodies.
std::string problem_of_rules(const std::string& order) {
    return problem_of(two + "[rules]\norder = " + order + "\n");
}

} // namespace

TEST(SceneSpec, EveryKeyIsRead) {
    const auto spec = parse(good);
    ASSERT_TRUE(spec) << spec.error().detail;
    ASSERT_TRUE(spec.value().scene);
    const SceneSpec& scene = *spec.value().scene;
    ASSERT_EQ(scene.bodies.size(), 4u);
    const SceneBodySpec& truck = scene.bodies[0];
    EXPECT_EQ(truck.name, "truck");
    EXPECT_EQ(truck.mesh.path, "folder/truck.glb");
    EXPECT_EQ(truck.group, "traffic");
    EXPECT_EQ(truck.mesh.origin, (std::array{2.5, 0.0, -0.5}));
    ASSERT_TRUE(truck.poses);
    EXPECT_EQ(truck.poses->path, "folder/truck.csv");
    EXPECT_FALSE(truck.pose);
    EXPECT_FALSE(truck.count);
    EXPECT_EQ(truck.line, 3u);
    const SceneBodySpec& wall = scene.bodies[1];
    EXPECT_EQ(wall.mesh.path, "/abs/wall.stl");
    EXPECT_EQ(wall.mesh.unit, "mm");
    EXPECT_EQ(wall.mesh.up, "y");
    ASSERT_TRUE(wall.pose);
    EXPECT_EQ(*wall.pose, Pose::from_quaternion({1, 0, 0, 0}, Vec3(1, 2, 3)));
    EXPECT_EQ(scene.bodies[2].count, 500u);
    EXPECT_TRUE(scene.bodies[2].mesh.rounds_to_float);
    EXPECT_EQ(scene.bodies[3].name, "factory");
    EXPECT_TRUE(scene.bodies[3].is_split);
    EXPECT_EQ(spec.value().query.level, Level::Count);
    EXPECT_EQ(spec.value().query.clearance, 0.5);
}

TEST(SceneSpec, PosesAndRulesAreRead) {
    const auto spec = parse(good);
    ASSERT_TRUE(spec) << spec.error().detail;
    const auto& poses = spec.value().scene->poses;
    ASSERT_TRUE(poses);
    EXPECT_EQ(poses->file.path, "folder/poses.npy");
    EXPECT_EQ(poses->file.length_factor, 100);
    EXPECT_EQ(poses->file.quat_order, "xyzw");
    EXPECT_EQ(poses->file.rigid_tolerance, 1e-4);
    EXPECT_EQ(poses->body_order, (std::vector<std::string>{"car.0", "car.1"}));
    EXPECT_TRUE(poses->nan_is_absent);
    const RulesSpec& rules = spec.value().scene->rules;
    EXPECT_EQ(rules.learn, 3u);
    ASSERT_EQ(rules.order.size(), 2u);
    EXPECT_TRUE(rules.order[0].ignores);
    EXPECT_EQ(rules.order[0].one, "group:traffic");
    EXPECT_EQ(rules.order[0].line, 18u);
    EXPECT_FALSE(rules.order[1].ignores);
    EXPECT_EQ(rules.order[1].other, "truck");
    EXPECT_EQ(rules.order[1].line, 19u);
}

TEST(SceneSpec, WhatIsLeftOutHasADefault) {
    const auto spec = parse(two);
    ASSERT_TRUE(spec) << spec.error().detail;
    const SceneSpec& scene = *spec.value().scene;
    EXPECT_FALSE(scene.poses);
    EXPECT_TRUE(scene.rules.order.empty());
    EXPECT_FALSE(scene.rules.learn);
    EXPECT_FALSE(
        parse("[a]\nmesh = \"a\"\n[b]\nmesh = \"b\"\n[poses]\nrandom = {}\n").value().scene);
}

TEST(SceneSpec, BodiesKeepTheOrderOfTheFile) {
    const auto spec = parse("[bodies]\nz = { mesh = \"z\" }\nm = { mesh = \"m\" }\n[bodies.a]\n"
                            "mesh = \"a\"\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    std::string names;
    for (const SceneBodySpec& body : spec.value().scene->bodies) {
        names += body.name;
    }
    EXPECT_EQ(names, "zma");
}

TEST(SceneSpec, WhatOnlyTwoBodiesHaveIsRefusedWithWhatToWrite) {
    EXPECT_EQ(problem_of("[a]\nmesh = \"a.obj\"\n" + two),
              "folder/job.toml:1: the job: [bodies] has all bodies; write [a] in it as a = { mesh "
              "= ... }, with its poses");
    EXPECT_THAT(problem_of(two + "[b]\nmesh = \"b.obj\"\n"), HasSubstr(":4: the job: [bodies]"));
    EXPECT_THAT(problem_of(two + "[query]\nignore = [[\"x\", \"y\"]]\n"),
                HasSubstr(":5: [query]: ignore is for two bodies; with [bodies] write [rules]"));
    EXPECT_THAT(problem_of(two + "[poses]\nrandom = { n = 3 }\n"),
                HasSubstr(":5: the job: [poses] random is for two bodies; with [bodies] give"));
    EXPECT_THAT(problem_of(two + "[poses]\nof = \"both\"\nfile = \"p.csv\"\n"),
                HasSubstr(":5: the job: [poses] of is for two bodies"));
    EXPECT_THAT(problem_of(two + "[poses]\ngrid = { x = [0, 1, 2] }\n"),
                HasSubstr("[poses] grid is for two bodies"));
    EXPECT_THAT(problem_of(two + "[cluster]\ndepth = { a = 3 }\n"),
                HasSubstr(":5: [cluster]: depth is for two bodies"));
    EXPECT_EQ(problem_of(two + "[cluster]\ndepth = \"auto\"\n"), "none");
}

TEST(SceneSpec, RulesNeedBodies) {
    EXPECT_THAT(problem_of("[a]\nmesh = \"a\"\n[b]\nmesh = \"b\"\n[poses]\nrandom = {}\n[rules]\n"),
                HasSubstr(":7: the job: [rules] is for a job with [bodies]; with [a] and [b] write "
                          "[query] ignore"));
}

TEST(SceneSpec, ADistanceNeedsItsEnd) {
    const std::string distance = two + "[query]\nlevel = \"distance\"\n";
    EXPECT_THAT(problem_of(distance),
                HasSubstr(":5: [query]: with [bodies], level distance needs"));
    EXPECT_EQ(problem_of(distance + "up_to = 2\n"), "none");
}

TEST(SceneSpec, HasNoContactMap) {
    for (const char* level : {"count", "pairs"}) {
        EXPECT_THAT(
            problem_of(two + "[query]\nlevel = \"" + std::string(level) + "\"\nmaps = true\n"),
            HasSubstr(":6: [query]: maps count the contacts of two bodies' triangles"));
    }
}

TEST(SceneSpec, ABodyHasOneKindOfPose) {
    EXPECT_EQ(problem_of_body("pose = [0,0,0,0,0,0,1]"),
              "folder/job.toml:2: [bodies] car: pose does not say which number is qw; give "
              "quat_order \"xyzw\" or \"wxyz\"");
    EXPECT_THAT(problem_of_body("pose = [0,0,0,1], quat_order = \"xyzw\""),
                HasSubstr("\"pose\" has to be [x, y, z, then the quaternion"));
    EXPECT_THAT(problem_of_body("pose = [0,0,0,0,0,0,2], quat_order = \"xyzw\""),
                HasSubstr("the quaternion of pose has the length 2; a rotation has 1"));
    EXPECT_THAT(problem_of_body("pose = [0,0,0,0,0,0,1], poses = \"p.csv\""),
                HasSubstr("either pose, the same at all steps, or poses"));
    EXPECT_THAT(problem_of_body("quat_order = \"xyzw\""),
                HasSubstr("quat_order belongs to pose or poses"));
    EXPECT_THAT(problem_of_body("origin = [1, 2]"), HasSubstr("\"origin\" has to be [x, y, z]"));
    EXPECT_THAT(problem_of_body("poses = \"\""), HasSubstr("poses has to be the name of a file"));
    EXPECT_EQ(problem_of_body("pose = [0,0,0,0,0,0,1], quat_order = \"xyzw\""), "none");
}

TEST(SceneSpec, InstancesNeedPosesOfTheirOwn) {
    for (const char* key : {"pose = [0,0,0,0,0,0,1], quat_order = \"xyzw\"",
                            "poses = \"p.csv\"",
                            "split = \"parts\""}) {
        EXPECT_THAT(problem_of_body("count = 2, " + std::string(key)),
                    HasSubstr("is for one body, and count makes several"))
            << key;
    }
    EXPECT_THAT(problem_of_body("count = 0"), HasSubstr("count = 0 is not between 1 and 16384"));
    EXPECT_THAT(problem_of_body("count = 16385"), HasSubstr("count = 16385 is not between"));
    EXPECT_EQ(problem_of_body("count = 16384"), "none");
}

TEST(SceneSpec, UnknownWordsNameThoseThatExist) {
    EXPECT_EQ(problem_of_body("grup = \"x\""),
              "folder/job.toml:2: [bodies] car has no key \"grup\"; did you mean \"group\"?");
    EXPECT_THAT(problem_of_body("split = \"part\""), HasSubstr("did you mean \"parts\"?"));
    EXPECT_THAT(problem_of(two + "[poses]\nfile = \"p\"\nabsent = \"none\"\n"),
                HasSubstr(":6: [poses]: absent \"none\" is not known"));
    EXPECT_THAT(problem_of(two + "[rules]\norders = []\n"), HasSubstr("did you mean \"order\"?"));
}

TEST(SceneSpec, NamesOfBodiesAreChecked) {
    EXPECT_THAT(problem_of("[bodies]\n"), HasSubstr(":1: the job: [bodies] is empty"));
    EXPECT_THAT(problem_of("[bodies]\ncar = 3\n"),
                HasSubstr(":2: the job: [bodies] car has to be a table"));
    EXPECT_THAT(problem_of("[bodies]\n\"group:x\" = { mesh = \"m\" }\n"),
                HasSubstr("no body's name begins with group:"));
    EXPECT_THAT(problem_of("[bodies]\n\"\" = { mesh = \"m\" }\n"), HasSubstr("1 to 256 bytes"));
    EXPECT_THAT(problem_of("[bodies]\n" + std::string(257, 'x') + " = { mesh = \"m\" }\n"),
                HasSubstr("1 to 256 bytes"));
    EXPECT_THAT(problem_of("[bodies]\ncar = { unit = \"m\" }\n"),
                HasSubstr(":2: [bodies] car: the key \"mesh\""));
}

TEST(SceneSpec, AFileOfPosesNamesEachBodyOnce) {
    EXPECT_THAT(problem_of(two + "[poses]\nunit = \"m\"\n"), HasSubstr("the key \"file\""));
    EXPECT_THAT(problem_of(two + "[poses]\nfile = \"p\"\nbody_order = [\"a\", \"a\"]\n"),
                HasSubstr(":6: [poses]: body_order names \"a\" twice"));
    EXPECT_THAT(problem_of(two + "[poses]\nfile = \"p\"\nbody_order = [1]\n"),
                HasSubstr("an array of bodies' names"));
    EXPECT_THAT(problem_of(two + "[poses]\nfile = \"p\"\nrigid_tolerance = -1\n"),
                HasSubstr("rigid_tolerance is negative"));
}

TEST(SceneSpec, VehiclesOfSumoAreRead) {
    const std::string text = "unit = \"mm\"\n" + two +
                             "[poses]\nfcd = { file = \"fcd.xml\", types = { passenger = \"a\", "
                             "\"truck/trailer\" = \"b\" }, z = -5, other_types = \"skip\" }\n";
    const auto spec = parse(text);
    ASSERT_TRUE(spec) << spec.error().detail;
    const auto again = parse_job(job_text(spec.value()), "job.toml");
    ASSERT_TRUE(again) << again.error().detail;
    for (const JobSpec& job : {spec.value(), again.value()}) {
        EXPECT_FALSE(job.scene->poses);
        ASSERT_TRUE(job.scene->fcd);
        const FcdSpec& fcd = *job.scene->fcd;
        EXPECT_EQ(fcd.path, "folder/fcd.xml");
        EXPECT_EQ(fcd.types.at("truck/trailer"), "b");
        EXPECT_EQ(fcd.z, -5);
        EXPECT_EQ(fcd.length_factor, 1000);
        EXPECT_TRUE(fcd.skips_other_types);
    }
}

TEST(SceneSpec, VehiclesOfSumoHaveBodiesOfTheirOwn) {
    const auto problem = [](const std::string& keys) {
        return problem_of(two + "[poses]\nfcd = { file = \"f.xml\", " + keys + " }\n");
    };
    EXPECT_THAT(problem("z = 1"), HasSubstr(":5: [poses] fcd: types has to name a body"));
    EXPECT_THAT(problem("types = {}"), HasSubstr("types has to name a body"));
    EXPECT_THAT(problem("types = { car = 1 }"), HasSubstr("types has the name of a body"));
    EXPECT_THAT(problem("types = { car = \"c\" }"),
                HasSubstr(":5: [poses]: fcd types: no entry of [bodies] is called \"c\""));
    EXPECT_THAT(problem("types = { car = \"a\" }, other_types = \"all\""),
                HasSubstr("other_types \"all\" is not known"));
    EXPECT_EQ(problem("types = { car = \"a\" }"), "none");
    EXPECT_THAT(problem_of(two + "[poses]\nfcd = { types = { car = \"a\" } }\n"),
                HasSubstr(":5: [poses] fcd: the key \"file\""));
    EXPECT_THAT(problem_of(two + "[poses]\nfile = \"p\"\nfcd = { file = \"f\" }\n"),
                HasSubstr(":5: [poses]: file is for a file of poses; leave out either it or fcd"));
    EXPECT_THAT(problem_of("[bodies]\na = { mesh = \"m\", count = 2 }\n[poses]\nfcd = { file = "
                           "\"f\", types = { car = \"a\" } }\n"),
                HasSubstr(":4: [poses]: fcd types gives the vehicles to \"a\" of line 2, so leave "
                          "out its count"));
}

TEST(SceneSpec, ARuleIsAPairOfPatterns) {
    EXPECT_EQ(problem_of_rules("[{ ignore = [\"a\"] }]"),
              "folder/job.toml:5: [rules] order: ignore has to be two names or patterns, such as "
              "[\"car.*\", \"ground\"]");
    EXPECT_THAT(problem_of_rules("[{ test = [\"a\", 1] }]"), HasSubstr("test has to be two names"));
    EXPECT_THAT(problem_of_rules("[{ test = [\"a\", \"\"] }]"), HasSubstr("has an empty name"));
    EXPECT_THAT(problem_of_rules("[[\"a\", \"b\"]]"), HasSubstr("order is an array of rules"));
    EXPECT_THAT(problem_of_rules("[{ ignore = [\"a\", \"b\"], test = [\"a\", \"b\"] }]"),
                HasSubstr("order is an array of rules"));
    EXPECT_THAT(problem_of_rules("[{ ignor = [\"a\", \"b\"] }]"),
                HasSubstr("did you mean \"ignore\"?"));
    EXPECT_THAT(problem_of(two + "[rules]\nlearn = -1\n"), HasSubstr("learn = -1 is not between"));
    EXPECT_EQ(problem_of_rules("[{ ignore = [\"a\", \"b\"] }]"), "none");
}

TEST(SceneSpec, ARuleIsWrittenAsAJobFileHasIt) {
    const SceneRule rule{false, "ca\"r", "group:x/wheel_*"};
    EXPECT_EQ(rule_text(rule), R"({ test = ["ca\"r", "group:x/wheel_*"] })");
    const auto spec = parse(two + "[rules]\norder = [" + rule_text(rule) + "]\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().scene->rules.order.front().one, rule.one);
}

TEST(SceneSpec, IsWrittenAsAJobFileThatGivesItAgain) {
    const auto spec = parse(good);
    ASSERT_TRUE(spec) << spec.error().detail;
    const std::string text = job_text(spec.value());
    const auto again = parse_job(text, "job.toml");
    ASSERT_TRUE(again) << again.error().detail << "\n" << text;
    EXPECT_EQ(job_text(again.value()), text);
    const SceneSpec& before = *spec.value().scene;
    const SceneSpec& after = *again.value().scene;
    ASSERT_EQ(after.bodies.size(), before.bodies.size());
    for (std::size_t i = 0; i < before.bodies.size(); ++i) {
        EXPECT_EQ(after.bodies[i].name, before.bodies[i].name);
        EXPECT_EQ(after.bodies[i].group, before.bodies[i].group);
        EXPECT_EQ(after.bodies[i].count, before.bodies[i].count);
        EXPECT_EQ(after.bodies[i].is_split, before.bodies[i].is_split);
        EXPECT_EQ(after.bodies[i].pose, before.bodies[i].pose);
        EXPECT_EQ(after.bodies[i].poses.has_value(), before.bodies[i].poses.has_value());
        EXPECT_EQ(after.bodies[i].mesh.unit, before.bodies[i].mesh.unit);
        EXPECT_EQ(after.bodies[i].mesh.up, before.bodies[i].mesh.up);
        EXPECT_EQ(after.bodies[i].mesh.rounds_to_float, before.bodies[i].mesh.rounds_to_float);
        EXPECT_EQ(after.bodies[i].mesh.origin, before.bodies[i].mesh.origin);
    }
    EXPECT_EQ(after.poses->body_order, before.poses->body_order);
    EXPECT_EQ(after.poses->nan_is_absent, before.poses->nan_is_absent);
    EXPECT_EQ(after.poses->file.length_factor, before.poses->file.length_factor);
    EXPECT_EQ(after.poses->file.rigid_tolerance, before.poses->file.rigid_tolerance);
    EXPECT_EQ(after.rules.learn, before.rules.learn);
    ASSERT_EQ(after.rules.order.size(), before.rules.order.size());
    EXPECT_EQ(after.rules.order[1].other, before.rules.order[1].other);
}

TEST(SceneSpec, OptionsHoldForAllBodies) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, two);
    options.precision = "float";
    const auto spec = make_job_spec(options);
    ASSERT_TRUE(spec) << spec.error().detail;
    for (const SceneBodySpec& body : spec.value().scene->bodies) {
        EXPECT_TRUE(body.mesh.rounds_to_float);
    }
    options.query.level = "distance";
    EXPECT_THAT(make_job_spec(options).error().detail,
                HasSubstr("--level distance and [bodies] of " + options.file +
                          ":1: with [bodies], level distance needs up_to"));
    options.query.up_to = 2.0;
    EXPECT_TRUE(make_job_spec(options));
    options.query = {};
    options.query.level = "count";
    options.query.maps = true;
    EXPECT_THAT(make_job_spec(options).error().detail,
                HasSubstr("--maps and [bodies] of " + options.file + ":1: maps count"));
    options.query = {};
    options.cluster.depth_b = "3";
    EXPECT_THAT(make_job_spec(options).error().detail,
                HasSubstr("--depth-b 3 and [bodies] of " + options.file + ":1: distribution"));
}

} // namespace cd::tests
