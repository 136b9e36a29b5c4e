// Proves that [motion] sets the question of a job, that what does not go together with it is
// refused where it stands, and that the text of a job reads the same.
#include "client/job/job_text.hpp"
#include "client/job/submission.hpp"
#include "client/spec/job_options.hpp"
#include "client/spec/query_spec.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

const std::string bodies = "[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n";
const std::string keys = "[poses]\nfile = \"keys.csv\"\n";

/// Makes a job whose table [motion] begins in line 7.
Result<JobSpec> read(const std::string& motion, const std::string& more = "") {
    return parse_job(bodies + keys + "[motion]\n" + motion + more, "folder/job.toml");
}

std::string problem_in(const Result<JobSpec>& spec) {
    return spec ? "none" : spec.error().detail;
}

std::string problem_with(const std::string& motion, const std::string& more = "") {
    return problem_in(read(motion, more));
}

} // namespace

TEST(MotionSpec, HasAResolutionAndAnEnd) {
    const auto spec = read("resolution = 0.25\nuntil = \"free\"\n",
                           "[query]\nlevel = \"any\"\nclearance = 0.5\n");
    ASSERT_TRUE(spec) << spec.error().detail;
    const Query& query = spec.value().query;
    EXPECT_EQ(query.question, Question::Motion);
    EXPECT_EQ(query.motion, (MotionQuery{0.25, Until::Free}));
    EXPECT_EQ(query.level, Level::Any);
    EXPECT_EQ(query.clearance, 0.5);
    EXPECT_EQ(query_problem(query), nullptr);
    const auto usual = read("resolution = 1\n");
    ASSERT_TRUE(usual);
    EXPECT_EQ(usual.value().query.motion, (MotionQuery{1, Until::Contact}));
    EXPECT_EQ(usual.value().query.level, Level::Pairs);
}

TEST(MotionSpec, ReadsTheSameFromItsOwnText) {
    for (const Until until : {Until::Contact, Until::Free, Until::End}) {
        const auto spec =
            read("resolution = 0.1\nuntil = \"" + std::string(to_text(until)) + "\"\n");
        ASSERT_TRUE(spec);
        const auto again = parse_job(job_text(spec.value()), "folder/job.toml");
        ASSERT_TRUE(again) << again.error().detail;
        EXPECT_EQ(again.value().query.motion, (MotionQuery{0.1, until}));
        EXPECT_EQ(again.value().query.question, Question::Motion);
        Submit submit;
        submit.bodies = {{}, {}};
        submit.query = spec.value().query;
        submit.poses.file = "keys.csv";
        const auto from_master = spec_of(submit);
        ASSERT_TRUE(from_master) << from_master.error().detail;
        EXPECT_EQ(from_master.value().query.motion, spec.value().query.motion);
    }
}

TEST(MotionSpec, RefusesWhatIsNoResolutionOrEnd) {
    EXPECT_THAT(problem_with(""), HasSubstr("job.toml:7: [motion]: resolution is missing"));
    for (const std::string number : {"0", "-1", "-0.0"}) {
        EXPECT_THAT(problem_with("resolution = " + number + "\n"),
                    HasSubstr("job.toml:8: [motion]: resolution is a length above 0"));
    }
    EXPECT_THAT(problem_with("resolution = 1\nuntil = \"contacts\"\n"), HasSubstr("job.toml:9"));
    EXPECT_THAT(problem_with("resolution = 1\nresolutoin = 2\n"), HasSubstr("resolutoin"));
}

TEST(MotionSpec, RefusesWhatDoesNotGoTogetherWithIt) {
    const std::string motion = "resolution = 1\n";
    for (const std::string level : {"count", "contacts", "distance"}) {
        EXPECT_THAT(problem_with(motion, "[query]\nlevel = \"" + level + "\"\n"),
                    HasSubstr("motions of [motion] are asked at level any or pairs"))
            << level;
    }
    EXPECT_THAT(problem_with(motion, "[query]\nmaps = true\n"), HasSubstr("leave out maps"));
    EXPECT_THAT(problem_with(motion, "[query]\nlevel = \"any\"\nup_to = 1\n"),
                HasSubstr("leave out up_to"));
    for (const std::string poses :
         {"[poses]\nrandom = { n = 5 }\n", "[poses]\ngrid = { x = [0, 1, 2] }\n"}) {
        EXPECT_THAT(problem_in(parse_job(bodies + poses + "[motion]\n" + motion, "job.toml")),
                    HasSubstr("job.toml:7: the job: a motion leads from each pose"));
    }
    EXPECT_THAT(
        problem_in(parse_job("[a]\nmesh = \"a.obj\"\n[shots]\nspacing = 1\n[motion]\n" + motion,
                             "job.toml")),
        HasSubstr("lines of [shots] do not move"));
}

TEST(MotionSpec, LevelsOfTheCommandLineAreChecked) {
    auto spec = read("resolution = 1\n");
    ASSERT_TRUE(spec);
    JobOptions options;
    options.query.level = "any";
    ASSERT_TRUE(apply(options, spec.value()));
    EXPECT_EQ(spec.value().query.question, Question::Motion);
    EXPECT_EQ(spec.value().query.level, Level::Any);
    options.query.level = "distance";
    const Status refused = apply(options, spec.value());
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().detail, HasSubstr("at level any or pairs"));
}

} // namespace cd::tests
