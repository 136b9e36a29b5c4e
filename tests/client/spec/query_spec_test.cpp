// Proves that `level = "distance"` is read from job files and from the command line, and that keys
// which conflict with it are refused with their line.
#include "client/spec/query_spec.hpp"

#include "client/job/job_text.hpp"
#include "client/spec/job_options.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Makes a job whose table [query] begins in line 7.
std::string job_with(const std::string& query) {
    return "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nrandom = { n = 10 }\n[query]\n" +
           query;
}

Result<JobSpec> read(const std::string& query) {
    return parse_job(job_with(query), "folder/job.toml");
}

std::string problem_with(const std::string& query) {
    const auto spec = read(query);
    if (spec) {
        return "none";
    }
    EXPECT_EQ(spec.error().code, ErrorCode::BadInput);
    return spec.error().detail;
}

const std::string distance = "level = \"distance\"\n";

} // namespace

TEST(AskedLevel, IsOneOfTheLevelsOrTheDistance) {
    for (const std::string_view word : asked_levels) {
        Query query;
        EXPECT_TRUE(set_asked_level(word, query));
        EXPECT_EQ(asked_level(query), word);
        EXPECT_EQ(query.question == Question::Distance, word == "distance");
        EXPECT_EQ(query_problem(query), nullptr);
    }
    Query query;
    EXPECT_FALSE(set_asked_level("near", query));
    EXPECT_TRUE(set_asked_level("distance", query));
    EXPECT_EQ(query.level, Level::Any);
    EXPECT_TRUE(set_asked_level("any", query));
    EXPECT_EQ(query.question, Question::Contacts);
}

TEST(AskedLevel, OfAJobFileMayBeTheDistance) {
    const auto spec = read(distance);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().query.question, Question::Distance);
    EXPECT_EQ(spec.value().query.level, Level::Any);
    EXPECT_FALSE(spec.value().query.up_to);
    EXPECT_EQ(read(distance + "up_to = 2.5\n").value().query.up_to, 2.5);
    EXPECT_EQ(read(distance + "ignore = [[\"wheel\", \"*\"]]\n").value().ignore.size(), 1u);
    EXPECT_EQ(read("level = \"any\"\n").value().query.question, Question::Contacts);
    EXPECT_THAT(problem_with("level = \"distances\"\n"), HasSubstr("did you mean \"distance\"?"));
}

TEST(AskedLevel, KeysThatDoNotGoWithADistanceAreRefusedInTheirLine) {
    EXPECT_THAT(problem_with(distance + "clearance = 0.0\n"),
                HasSubstr("folder/job.toml:9: [query]: level distance tells how far apart"));
    EXPECT_THAT(problem_with(distance + "limit_pairs = 5\n"),
                HasSubstr("job.toml:9: [query]: level distance lists no pairs"));
    EXPECT_THAT(problem_with("maps = true\n" + distance),
                HasSubstr("job.toml:8: [query]: level distance finds no contacts"));
    EXPECT_EQ(problem_with(distance + "maps = false\nlimit_pairs = 0\n"), "none");
}

TEST(AskedLevel, KeysThatNeedAHigherLevelAreRefusedInTheirLine) {
    for (const char* level : {"any", "count"}) {
        EXPECT_THAT(problem_with("level = \"" + std::string(level) + "\"\nlimit_pairs = 5\n"),
                    HasSubstr("folder/job.toml:9: [query]: limit_pairs cuts the lists of level "
                              "pairs and above"));
    }
    EXPECT_THAT(problem_with("maps = true\nlevel = \"any\"\n"),
                HasSubstr("folder/job.toml:8: [query]: maps need level count"));
    EXPECT_EQ(problem_with("level = \"any\"\nlimit_pairs = 0\nmaps = false\n"), "none");
    EXPECT_EQ(problem_with("level = \"contacts\"\nlimit_pairs = 5\nmaps = true\n"), "none");
    EXPECT_EQ(problem_with("level = \"count\"\nmaps = true\n"), "none");
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, job_with("maps = true\nlimit_pairs = 5\n"));
    options.query.level = "any";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("leave out limit_pairs"));
    options.query.limit_pairs = 0;
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("leave out maps"));
}

TEST(AskedLevel, AConflictOfAnOptionNamesItAndTheLineOfTheFile) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, job_with("maps = true\nlimit_pairs = 5\n"));
    options.query.level = "any";
    EXPECT_EQ(make_job_spec(options).error().detail.find("--level any and limit_pairs of " +
                                                         options.file + ":9: limit_pairs cuts"),
              0u);
    options.query.limit_pairs = 0;
    EXPECT_EQ(make_job_spec(options).error().detail.find("--level any and maps of " + options.file +
                                                         ":8: maps need level count"),
              0u);
    options.query.maps = true;
    EXPECT_EQ(make_job_spec(options).error().detail.find("--maps and --level any: maps need"), 0u);
    options.query = {};
    options.query.up_to = 2.5;
    EXPECT_EQ(make_job_spec(options).error().detail.find("--up-to 2.5: up_to belongs to"), 0u);
    write_text(options.file, job_with("level = \"any\"\n[motion]\nresolution = 1\n"));
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("no order"));
    write_text(options.file, "[a]\nmesh = \"a.obj\"\n[shots]\nspacing = 1\n");
    options.query = {};
    options.query.clearance = 0.5;
    EXPECT_EQ(make_job_spec(options).error().detail.find("--clearance 0.5 and [shots] of " +
                                                         options.file + ":3: a line of [shots]"),
              0u);
}

TEST(AskedLevel, AConflictOfOtherTablesNamesWhatSetsIt) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    const auto problem = [&] { return make_job_spec(options).error().detail; };
    write_text(options.file, job_with("level = \"count\"\n[cluster]\nq = 5\n"));
    EXPECT_EQ(problem().find(options.file + ":10: q and claim belong to the paper's"), 0u);
    options.cluster.strategy = "earliest-finish";
    EXPECT_EQ(problem().find("--strategy earliest-finish and q of " + options.file +
                             ":10: q and claim belong to"),
              0u);
    options.cluster = {};
    write_text(options.file, job_with("maps = true\n[output]\nformats = [\"vtp\"]\n"));
    EXPECT_TRUE(make_job_spec(options));
    write_text(options.file, job_with("level = \"any\"\n[output]\nformats = [\"vtp\"]\n"));
    EXPECT_EQ(problem().find(options.file + ":10: format vtp shows"), 0u);
    write_text(options.file, job_with("level = \"pairs\"\n[output]\nformats = [\"vtp\"]\n"));
    options.query.level = "any";
    EXPECT_EQ(problem().find("--level any and formats of " + options.file + ":10: format vtp"), 0u);
    options.output.formats = {"npz", "glb"};
    EXPECT_EQ(problem().find("--formats npz,glb and --level any: format glb shows"), 0u);
}

TEST(AskedLevel, AnUpToBelongsToTheDistance) {
    for (const char* level : {"any", "count", "pairs", "contacts"}) {
        EXPECT_THAT(problem_with("up_to = 1\nlevel = \"" + std::string(level) + "\"\n"),
                    HasSubstr("job.toml:8: [query]: up_to belongs to level distance"));
    }
    EXPECT_THAT(problem_with("up_to = 1\n"), HasSubstr("up_to belongs to level distance"));
    for (const char* length : {"0", "5e-324", "1e300"}) {
        EXPECT_EQ(problem_with(distance + "up_to = " + length + "\n"), "none") << length;
    }
    EXPECT_THAT(problem_with(distance + "up_to = -1\n"),
                HasSubstr("job.toml:9: [query]: up_to is a length of at least 0"));
    for (const char* length : {"nan", "inf", "\"1\"", "true"}) {
        EXPECT_THAT(problem_with(distance + "up_to = " + length + "\n"), HasSubstr("\"up_to\""));
    }
}

TEST(AskedLevel, OfTheCommandLineOverridesThatOfTheFile) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, job_with("level = \"count\"\n"));
    options.query.level = "distance";
    options.query.up_to = 0.5;
    const auto spec = make_job_spec(options);
    ASSERT_TRUE(spec) << spec.error().detail;
    EXPECT_EQ(spec.value().query.question, Question::Distance);
    EXPECT_EQ(spec.value().query.up_to, 0.5);
    options.query.level = "pairs";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("up_to belongs to"));
    write_text(options.file, job_with(distance + "up_to = 3\n"));
    options.query.level.clear();
    EXPECT_EQ(make_job_spec(options).value().query.up_to, 0.5);
    options.query.up_to.reset();
    EXPECT_EQ(make_job_spec(options).value().query.up_to, 3);
    options.query.level = "any";
    EXPECT_THAT(make_job_spec(options).error().detail, HasSubstr("up_to belongs to"));
}

TEST(AskedLevel, OptionsThatDoNotGoWithADistanceAreRefused) {
    const TemporaryFolder folder;
    JobOptions options;
    options.file = (folder / "job.toml").string();
    write_text(options.file, job_with(distance));
    const auto problem_with_option = [&](const auto& change) {
        JobOptions changed = options;
        change(changed.query);
        const auto spec = make_job_spec(changed);
        return spec ? "none" : spec.error().detail;
    };
    EXPECT_THAT(problem_with_option([](QueryOptions& q) { q.clearance = 1; }),
                HasSubstr("leave out clearance"));
    EXPECT_THAT(problem_with_option([](QueryOptions& q) { q.limit_pairs = 1; }),
                HasSubstr("leave out limit_pairs"));
    EXPECT_THAT(problem_with_option([](QueryOptions& q) { q.maps = true; }),
                HasSubstr("leave out maps"));
    EXPECT_THAT(problem_with_option([](QueryOptions& q) { q.level = "near"; }),
                HasSubstr("is not one of any, count, pairs, contacts, distance"));
    for (const double none : {-1.0, HUGE_VAL, std::nan("")}) {
        EXPECT_THAT(problem_with_option([&](QueryOptions& q) { q.up_to = none; }),
                    HasSubstr("--up-to is a finite"));
    }
}

TEST(AskedLevel, IsWrittenAsItIsRead) {
    const auto spec = read(distance + "up_to = 0.25\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    const std::string text = job_text(spec.value());
    EXPECT_THAT(text, HasSubstr("\n[query]\nlevel = \"distance\"\nup_to = 0.25\n"));
    const auto again = parse_job(text, "job.toml");
    ASSERT_TRUE(again) << again.error().detail;
    EXPECT_EQ(again.value().query.question, Question::Distance);
    EXPECT_EQ(again.value().query.up_to, 0.25);
    EXPECT_EQ(job_text(again.value()), text);
}

} // namespace cd::tests
