// Proves that run.json restores its content, that hostile text is refused with a reason, and when
// two runs belong to one job.
#include "client/folder/run_manifest.hpp"

#include "client/folder/run_folder.hpp"
#include "client/job/job_text.hpp"
#include "client/spec/job_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace cd::tests {

namespace {

using testing::HasSubstr;

RunManifest example(PosesKind kind) {
    RunManifest manifest;
    manifest.origin.program = "cdctl 0.1.0";
    manifest.origin.commit = "0123abcd";
    if (kind == PosesKind::Random) {
        manifest.where.master = "node-1:7600";
        manifest.where.job = "j-4f2a";
        manifest.where.workers = 3;
    }
    manifest.name = "a \"job\"";
    manifest.unit = "mm";
    manifest.job = "name = \"a job\"\n";
    manifest.bodies = {{{sha256({}), "a", "/m/car.obj", "in", false, "y", true}, {"wheel", "hull"}},
                       {{sha256({}), "post", "/m/post.stl", "mm", true}}};
    manifest.bodies[1].origin = {0.5, -1, 2};
    manifest.query.level = Level::Contacts;
    manifest.query.limit_pairs = 7;
    IgnoredRange range;
    range.a_end = 5;
    range.b_begin = 2;
    range.b_end = 3;
    manifest.query.ignored = {range};
    manifest.poses.kind = kind;
    manifest.poses.count = 6;
    manifest.poses.hash = sha256({});
    if (kind == PosesKind::Random) {
        manifest.query.clearance = 0.005;
    } else if (kind == PosesKind::Grid) {
        manifest.outcome.tolerance = 0.1;
    }
    if (kind == PosesKind::Grid) {
        Grid grid;
        grid.position[0] = {0, 0.1, 3};
        grid.rotation[2] = rotation_axis({0, 30, 2}, 2);
        manifest.poses.grid = grid;
    } else if (kind == PosesKind::Random) {
        manifest.poses.random = RandomPoses{6, 18446744073709551615u, 0.1, 0.2};
    } else {
        manifest.poses.file = "/m/poses.npy";
        manifest.poses.quat_order = "xyzw";
        manifest.poses.unit = "cm";
        manifest.poses.rigid_tolerance = 0.001;
    }
    manifest.outcome.answered = 6;
    manifest.outcome.digest = sha256({});
    if (kind != PosesKind::Grid) {
        manifest.outcome.reused = ManifestReuse{"/runs/old", sha256({}), 5};
    }
    manifest.formats = {"csv", "npz"};
    manifest.files = {{"records", 12}, {"inputs/scenarios", 34}};
    return manifest;
}

TEST(RunManifest, GivesBackWhatWasSaid) {
    for (const PosesKind kind : {PosesKind::Grid, PosesKind::File, PosesKind::Random}) {
        const RunManifest manifest = example(kind);
        const auto parsed = parse_manifest(manifest_json(manifest));
        ASSERT_TRUE(parsed) << parsed.error().detail;
        EXPECT_EQ(manifest_json(parsed.value()), manifest_json(manifest));
        EXPECT_TRUE(is_same_job(parsed.value(), manifest));
        EXPECT_EQ(parsed.value().poses.grid, manifest.poses.grid);
        EXPECT_EQ(parsed.value().query.clearance, manifest.query.clearance);
        EXPECT_EQ(parsed.value().where.workers, manifest.where.workers);
        EXPECT_EQ(JobBody(parsed.value().bodies[0]), JobBody(manifest.bodies[0]));
        EXPECT_TRUE(parsed.value().is_complete());
    }
}

TEST(RunManifest, PassesOverKeysThatItDoesNotKnowAndRefusesALaterFormat) {
    auto json = nlohmann::json::parse(manifest_json(example(PosesKind::File)));
    json["colour"] = {1, 2};
    EXPECT_TRUE(parse_manifest(json.dump()));
    json["format"] = 4;
    const auto later = parse_manifest(json.dump());
    ASSERT_FALSE(later);
    EXPECT_THAT(later.error().detail, HasSubstr("use a later cdctl"));
}

TEST(RunManifest, EveryKeyThatIsMissingOrOfAnotherTypeIsRefusedOrDoesNoHarm) {
    for (const PosesKind kind : {PosesKind::Grid, PosesKind::File, PosesKind::Random}) {
        const auto json = nlohmann::json::parse(manifest_json(example(kind)));
        const auto flat = json.flatten();
        for (const auto& [path, value] : flat.items()) {
            for (const nlohmann::json& other : std::vector<nlohmann::json>{
                     nullptr, -1, 1e300, "x", true, nlohmann::json::array({1})}) {
                auto damaged = json;
                damaged[nlohmann::json::json_pointer(path)] = other;
                const auto parsed = parse_manifest(damaged.dump());
                if (!parsed) {
                    EXPECT_FALSE(parsed.error().detail.empty()) << path;
                } else {
                    EXPECT_TRUE(parse_manifest(manifest_json(parsed.value()))) << path;
                }
            }
        }
    }
    for (const char* text : {"", "{", "[]", "null", "{\"format\": 1}"}) {
        EXPECT_FALSE(parse_manifest(text)) << text;
    }
}

TEST(RunManifest, OnlyAProgramThatKnowsAClearanceReadsItsRecords) {
    auto without = nlohmann::json::parse(manifest_json(example(PosesKind::File)));
    EXPECT_EQ(without["record_version"], 2);
    EXPECT_FALSE(without["query"].contains("clearance"));
    auto with = nlohmann::json::parse(manifest_json(example(PosesKind::Random)));
    EXPECT_EQ(with["record_version"], 3);
    for (nlohmann::json* const json : {&without, &with}) {
        (*json)["record_version"] = 5 - (*json)["record_version"].get<int>();
        const auto parsed = parse_manifest(json->dump());
        ASSERT_FALSE(parsed);
        EXPECT_THAT(parsed.error().detail, HasSubstr("records are of another version"));
    }
    with["record_version"] = 3;
    with["query"]["clearance"] = -0.5;
    const auto negative = parse_manifest(with.dump());
    ASSERT_FALSE(negative);
    EXPECT_THAT(negative.error().detail, HasSubstr("clearance is out of range"));
}

/// Makes a run whose question is how far the bodies are apart.
RunManifest distance_example() {
    RunManifest manifest = example(PosesKind::File);
    manifest.query.level = Level::Any;
    manifest.query.limit_pairs = 0;
    manifest.query.question = Question::Distance;
    manifest.query.up_to = 2.5;
    return manifest;
}

TEST(RunManifest, KeepsTheQuestionOfTheDistance) {
    RunManifest manifest = distance_example();
    const auto json = nlohmann::json::parse(manifest_json(manifest));
    EXPECT_EQ(json["record_version"], 3);
    EXPECT_EQ(json["query"]["question"], "distance");
    EXPECT_EQ(json["query"]["up_to"], 2.5);
    const auto parsed = parse_manifest(json.dump());
    ASSERT_TRUE(parsed) << parsed.error().detail;
    EXPECT_EQ(parsed.value().query.question, Question::Distance);
    EXPECT_EQ(parsed.value().query.up_to, 2.5);
    EXPECT_TRUE(is_same_job(parsed.value(), manifest));
    manifest.query.up_to = 2;
    EXPECT_FALSE(is_same_job(parsed.value(), manifest));
    manifest.query.up_to.reset();
    EXPECT_FALSE(nlohmann::json::parse(manifest_json(manifest))["query"].contains("up_to"));
    RunManifest contacts = manifest;
    contacts.query.question = Question::Contacts;
    EXPECT_FALSE(is_same_job(contacts, manifest));
    EXPECT_FALSE(nlohmann::json::parse(manifest_json(contacts))["query"].contains("question"));
}

TEST(RunManifest, KeepsTheQuestionOfShots) {
    RunManifest manifest = example(PosesKind::Shots);
    manifest.query.level = Level::Pairs;
    manifest.query.clearance.reset();
    manifest.query.question = Question::Shots;
    const RunManifest all = manifest;
    manifest.query.first_hits = true;
    const auto json = nlohmann::json::parse(manifest_json(manifest));
    EXPECT_EQ(json["record_version"], 3);
    EXPECT_EQ(json["poses"]["kind"], "shots");
    EXPECT_EQ(json["query"]["question"], "shots");
    const auto parsed = parse_manifest(json.dump());
    ASSERT_TRUE(parsed) << parsed.error().detail;
    EXPECT_EQ(parsed.value().poses.kind, PosesKind::Shots);
    EXPECT_EQ(parsed.value().query.question, Question::Shots);
    EXPECT_TRUE(parsed.value().query.first_hits);
    EXPECT_TRUE(is_same_job(parsed.value(), manifest));
    EXPECT_FALSE(is_same_job(parsed.value(), all));
    auto distance = json;
    distance["query"]["question"] = "distance";
    distance["query"]["level"] = "any";
    EXPECT_THAT(parse_manifest(distance.dump()).error().detail, HasSubstr("first hits without"));
}

TEST(RunManifest, KeepsTheQuestionOfMotions) {
    RunManifest manifest = example(PosesKind::File);
    manifest.query.level = Level::Pairs;
    manifest.query.question = Question::Motion;
    manifest.query.motion = MotionQuery{0.25, Until::Free};
    const auto json = nlohmann::json::parse(manifest_json(manifest));
    EXPECT_EQ(json["record_version"], 3);
    EXPECT_EQ(json["query"]["question"], "motion");
    EXPECT_EQ(json["query"]["resolution"], 0.25);
    EXPECT_EQ(json["query"]["until"], "free");
    const auto parsed = parse_manifest(json.dump());
    ASSERT_TRUE(parsed) << parsed.error().detail;
    EXPECT_EQ(parsed.value().query.motion, manifest.query.motion);
    EXPECT_TRUE(is_same_job(parsed.value(), manifest));
    for (const MotionQuery other : {MotionQuery{0.5, Until::Free}, MotionQuery{0.25, Until::End}}) {
        manifest.query.motion = other;
        EXPECT_FALSE(is_same_job(parsed.value(), manifest)) << other.resolution;
    }
    auto damaged = json;
    damaged["query"]["until"] = "noon";
    EXPECT_THAT(parse_manifest(damaged.dump()).error().detail, HasSubstr("end of its motions"));
    damaged["query"].erase("until");
    EXPECT_FALSE(parse_manifest(damaged.dump()));
    damaged = json;
    damaged["query"]["resolution"] = 0;
    EXPECT_THAT(parse_manifest(damaged.dump()).error().detail, HasSubstr("resolution"));
}

TEST(RunManifest, RefusesQueriesThatNoJobAsks) {
    const auto json = nlohmann::json::parse(manifest_json(distance_example()));
    const auto refusal_with = [&](const char* key, const nlohmann::json& value) {
        auto changed = json;
        changed["query"][key] = value;
        const auto parsed = parse_manifest(changed.dump());
        return parsed ? "taken" : parsed.error().detail;
    };
    EXPECT_EQ(refusal_with("up_to", 0), "taken");
    EXPECT_THAT(refusal_with("up_to", -1), HasSubstr("up_to is out of range"));
    EXPECT_THAT(refusal_with("question", "penetration"), HasSubstr("use a later cdctl"));
    EXPECT_THAT(refusal_with("question", "motion"), HasSubstr("\"until\" is missing"));
    EXPECT_THAT(refusal_with("question", "shots"), HasSubstr("an up_to without the question"));
    EXPECT_THAT(refusal_with("level", "pairs"), HasSubstr("a distance with a level"));
    EXPECT_THAT(refusal_with("clearance", 1), HasSubstr("a distance with a level, clearance"));
    EXPECT_THAT(refusal_with("maps", true), HasSubstr("maps"));
    auto old = json;
    old["record_version"] = 2;
    EXPECT_THAT(parse_manifest(old.dump()).error().detail,
                HasSubstr("records are of another version"));
    old["query"].erase("question");
    EXPECT_THAT(parse_manifest(old.dump()).error().detail, HasSubstr("an up_to without"));
}

TEST(RunManifest, AJobIsItsMeshesPosesAndQuery) {
    const RunManifest one = example(PosesKind::File);
    RunManifest other = one;
    other.name = "another";
    other.bodies[0].file = "/n/car.obj";
    other.where.threads = 64;
    EXPECT_TRUE(is_same_job(one, other));
    other.query.level = Level::Pairs;
    EXPECT_FALSE(is_same_job(one, other));
    other = one;
    other.query.clearance = 0.0;
    EXPECT_FALSE(is_same_job(one, other));
    other = one;
    other.bodies[1].mesh.bytes[0] ^= std::byte{1};
    EXPECT_FALSE(is_same_job(one, other));
    other = one;
    other.poses.hash->bytes[0] ^= std::byte{1};
    EXPECT_FALSE(is_same_job(one, other));

    const RunManifest random = example(PosesKind::Random);
    other = random;
    other.poses.hash.reset(); // While the poses are generated.
    EXPECT_TRUE(is_same_job(random, other));
    other.poses.random->seed = 2;
    EXPECT_FALSE(is_same_job(random, other));
}

TEST(RunManifest, ARunOfAnEarlierVersionUnderAToleranceIsReadAndNotRunAgain) {
    const RunManifest exact = example(PosesKind::File);
    auto json = nlohmann::json::parse(manifest_json(exact));
    json["format"] = 1;
    json["query"]["tolerance"] = 0.0;
    const auto without = parse_manifest(json.dump());
    ASSERT_TRUE(without) << without.error().detail;
    EXPECT_TRUE(is_same_job(without.value(), exact));
    EXPECT_TRUE(check_exact(without.value()));

    json["query"]["tolerance"] = 0.25;
    const std::string job = "name = \"\\ntolerance = 1\"\n[a]\nmesh = \"a.obj\"\n[b]\nmesh = "
                            "\"b.obj\"\n[poses]\nfile = \"p.csv\"\nrigid_tolerance = 1\n"
                            "[query]\nlevel = \"count\"\n";
    json["job"] = job + "tolerance = 0.25\nmaps = true\n";
    const auto with = parse_manifest(json.dump());
    ASSERT_TRUE(with) << with.error().detail;
    EXPECT_EQ(with.value().job, job + "maps = true\n");
    EXPECT_TRUE(parse_job(with.value().job, "run.json"));
    EXPECT_FALSE(is_same_job(with.value(), exact));
    EXPECT_TRUE(is_same_job(with.value(), parse_manifest(manifest_json(with.value())).value()));
    EXPECT_THAT(check_exact(with.value()).error().detail, HasSubstr("had a tolerance of 0.25"));
}

TEST(RunManifest, ReusingAnotherRunIsAnotherWayToTheSameJob) {
    const RunManifest one = example(PosesKind::File);
    RunManifest other = one;
    other.outcome.reused->scenarios = 0; // While it is not known.
    EXPECT_TRUE(reuses_same_run(one, other));
    other.outcome.reused->digest.reset();
    EXPECT_FALSE(reuses_same_run(one, other));
    other = one;
    other.outcome.reused->run = "/runs/older";
    EXPECT_FALSE(reuses_same_run(one, other));
    other.outcome.reused.reset();
    EXPECT_FALSE(reuses_same_run(one, other));
    EXPECT_TRUE(reuses_same_run(other, other));
    EXPECT_TRUE(is_same_job(one, other));
}

TEST(RunManifest, ListedFilesStayInTheirFolder) {
    for (const char* name : {"records", "inputs/meshes/x.mesh", "..x"}) {
        EXPECT_TRUE(is_inside(name)) << name;
    }
    for (const char* name : {"", "/etc/passwd", "../x", "inputs/../../x", ".."}) {
        EXPECT_FALSE(is_inside(name)) << name;
    }
}

TEST(RunManifest, TimesAreInUtc) {
    EXPECT_EQ(iso_time(0), "1970-01-01T00:00:00Z");
    EXPECT_EQ(iso_time(1772366400), "2026-03-01T12:00:00Z");
}

TEST(JobText, IsReadBackToTheSameJob) {
    constexpr const char* bodies = "name = \"a \\\"job\\\"\"\nunit = \"mm\"\n\n"
                                   "[a]\nmesh = \"/m/car.obj\"\nup = \"y\"\n\n"
                                   "[b]\nmesh = \"/m/post.stl\"\nunit = \"in\"\nname = \"post\"\n"
                                   "precision = \"float\"\n\n[poses]\n";
    constexpr const char* rest =
        "\n[query]\nlevel = \"contacts\"\nclearance = 0.005\nlimit_pairs = 7\nmaps = true\n"
        "ignore = [[\"wheel_*\", \"a\\\\*b\"], [\"x\", \"*\"]]\n\n[output]\ndir = \"/out\"\n"
        "formats = [\"json\", \"npz\"]\n";
    constexpr const char* cluster =
        "\n[cluster]\nstrategy = \"lowest\"\nq = 7\nv_kb = 64\nclaim = true\nseed = 9\n"
        "analysis = \"never\"\nhints = false\n";
    for (const char* poses :
         {"grid = { x = [-1, 2.5, 3], yaw_deg = [0, 350, 36] }\nunit = \"cm\"\n",
          "grid = { z = [1e+30, 1e+30, 1] }\n",
          "grid = { }\n",
          "random = { n = 6, seed = 9223372036854775807, penetration = [0.1, 0.2] }\n",
          "file = \"/m/p.npy\"\nunit = \"in\"\nquat_order = \"xyzw\"\nof = \"both\"\n"
          "rigid_tolerance = 0.001\n"}) {
        const std::string text = std::string(bodies) + poses + rest + cluster;
        const auto spec = parse_job(text, "/m/job.toml");
        ASSERT_TRUE(spec) << spec.error().detail;
        EXPECT_EQ(job_text(spec.value()), text);
    }
}

TEST(JobText, ANumberAboveTheIntegersOfTomlStaysANumber) {
    JobSpec spec;
    GridSpec grid;
    grid.axes = std::vector<GridAxis>(6);
    grid.axes[0] = {12345678901234567000.0, 12345678901234567000.0, 1};
    spec.poses = grid;
    spec.bodies[0].path = spec.bodies[1].path = "/m/car.obj";
    const auto read = parse_job(job_text(spec), "/m/job.toml");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(std::get<GridSpec>(read.value().poses).axes, grid.axes);
}

TEST(JobText, DepthsKeepTheirBodies) {
    JobSpec spec;
    spec.bodies[0].path = spec.bodies[1].path = "/m/car.obj";
    spec.cluster.set_depth(1, 4);
    EXPECT_THAT(job_text(spec), HasSubstr("depth = { a = \"auto\", b = 4 }\n"));
    const auto read = parse_job(job_text(spec), "/m/job.toml");
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().cluster.depth(0), std::nullopt);
    EXPECT_EQ(read.value().cluster.depth(1), 4u);
}

} // namespace

} // namespace cd::tests
