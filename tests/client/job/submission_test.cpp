// Proves that jobs of shot lines, of paths between poses and of many bodies can be read from their
// submission.
#include "client/job/submission.hpp"

#include "client/job/job_text.hpp"
#include "common/job/poses/pose_source.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

PreparedJob job_of(const std::string& shots) {
    PreparedJob job;
    job.spec = parse_job("name = \"rays\"\n[a]\nmesh = \"/a.obj\"\n[shots]\n" + shots, "/job.toml")
                   .value();
    job.meshes.assign(2, share(make_gridded_box(Vec3(1, 1, 1), 1)));
    job.query = job.spec.query;
    job.poses = make_list_source(std::vector<Scenario>(3));
    return job;
}

} // namespace

TEST(Submission, TellsTheLinesOfTheJob) {
    for (const std::string shots :
         {"spacing = 0.5\ntile = 16\noffset = [0.25, 0.75]\nazimuth_deg = [0, 270, 4]\n",
          "spacing = 2\njitter = { seed = 5 }\nelevation_deg = [90, 90, 1]\nfirst = true\n",
          "file = \"rays.npy\"\nform = \"rays\"\n"}) {
        SCOPED_TRACE(shots);
        const PreparedJob job = job_of(shots);
        const Submit submit = submission_of(job);
        EXPECT_EQ(submit.poses.kind, PosesKind::Shots);
        EXPECT_EQ(submit.bodies[1].name, "lines");
        const auto spec = spec_of(submit);
        ASSERT_TRUE(spec) << spec.error().detail;
        EXPECT_EQ(job_text(spec.value()), job_text(job.spec));
    }
    Submit submit = submission_of(job_of("spacing = 1\n"));
    submit.poses.axes.pop_back();
    EXPECT_EQ(spec_of(submit).error().code, ErrorCode::BadFrame);
    submit = submission_of(job_of("spacing = 1\n"));
    submit.poses.shots->spacing = -1;
    EXPECT_FALSE(spec_of(submit));
}

TEST(Submission, OnlyTheTwoBodiesOfAJobHaveNamesByDefault) {
    JobBody body;
    body.name = "a";
    EXPECT_EQ(spec_of(body, 0).name, "");
    for (std::size_t number = 1; number < 500; ++number) {
        EXPECT_EQ(spec_of(body, number).name, "a") << "of body " << number << " of a scene";
    }
    body.name = "b";
    EXPECT_EQ(spec_of(body, 1).name, "");
}

TEST(Submission, TellsThePathBetweenPoses) {
    const std::string bodies = "name = \"way\"\n[a]\nmesh = \"/a.obj\"\n[b]\nmesh = \"/b.obj\"\n";
    const std::string line = "[poses]\nline = { from = [0, 0, 0], to = [1, 0, 0] }\n";
    const std::string motion = "[motion]\nresolution = 0.5\nchord = 0.3\n";
    for (const std::string& text : {line + "max_step = 0.1\n",
                                    std::string("[poses]\nfile = \"/keys.csv\"\nmax_step = 0.1\n"),
                                    line + motion,
                                    line + motion + "[query]\nclearance = 0.1\n"}) {
        SCOPED_TRACE(text);
        PreparedJob job;
        job.spec = parse_job(bodies + text, "/job.toml").value();
        job.meshes.assign(2, share(make_gridded_box(Vec3(1, 1, 1), 1)));
        job.poses = make_list_source(std::vector<Scenario>(3));
        job.query = job.spec.query;
        if (job.spec.chord) {
            job.query.clearance = job.query.clearance.value_or(0) + *job.spec.chord;
        }
        Submit submit = submission_of(job);
        EXPECT_EQ(submit.query.clearance, job.query.clearance);
        const auto spec = spec_of(submit);
        ASSERT_TRUE(spec) << spec.error().detail;
        EXPECT_EQ(job_text(spec.value()), job_text(job.spec));
        EXPECT_TRUE(parse_job(job_text(spec.value()), "/job.toml"));
        ASSERT_TRUE(submit.poses.path);
        submit.poses.path->max_step = -1;
        EXPECT_EQ(spec_of(submit).error().code, ErrorCode::BadFrame);
    }
}

} // namespace cd::tests
