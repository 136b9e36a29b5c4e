// Proves that a job with [bodies] is prepared with a mesh, a tree and a name for each body, and
// that exports and submissions name its bodies.
#include "client/job/prepared_job.hpp"
#include "client/job/submission.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

using testing::HasSubstr;

constexpr const char* pyramid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                "g base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

class SceneJob : public testing::Test {
  protected:
    SceneJob() {
        write_text(folder_ / "car.obj", pyramid);
        write_text(folder_ / "wall.obj", std::string(pyramid) + "f 2 3 1\n");
        write_text(folder_ / "poses.csv",
                   "step,body,x\n0,car.0,0\n0,car.1,0.5\n1,car.0,9\n1,car.1,9\n");
        write_text(folder_ / "job.toml",
                   "name = \"yard\"\n[bodies]\ncar = { mesh = \"car.obj\", count = 2 }\n"
                   "wall = { mesh = \"wall.obj\", precision = \"float\", pose = [0, 0, 0, 0, 0, 0, "
                   "1], quat_order = \"xyzw\" }\n[poses]\nfile = \"poses.csv\"\n"
                   "[rules]\norder = [{ ignore = [\"car.1/base\", \"wall\"] }]\n"
                   "[query]\nlevel = \"count\"\n");
    }

    Result<PreparedJob> prepared(Trees trees) {
        auto spec = read_job_file(folder_ / "job.toml");
        EXPECT_TRUE(spec) << spec.error().detail;
        TreeCache cache{std::filesystem::path()};
        return prepare_job(std::move(spec.value()), trees, cache, pool_);
    }

    TemporaryFolder folder_;
    ThreadPool pool_{1};
};

} // namespace

TEST_F(SceneJob, HasAMeshATreeAndANameForEachBody) {
    const auto job = prepared(Trees::Always);
    ASSERT_TRUE(job) << job.error().detail;
    EXPECT_EQ(job.value().names, (std::vector<std::string>{"car.0", "car.1", "wall"}));
    ASSERT_EQ(job.value().meshes.size(), 3u);
    EXPECT_EQ(job.value().meshes[0], job.value().meshes[1]);
    ASSERT_EQ(job.value().trees.size(), 3u);
    EXPECT_EQ(job.value().trees[0], job.value().trees[1]);
    EXPECT_EQ(job.value().trees[2]->mesh().triangles().size(), 5u);
    EXPECT_EQ(job.value().poses->count(), 4u);
    EXPECT_EQ(job.value().query.ignored, (std::vector<IgnoredRange>{{0, 1, 0, 5, 1, 2}}));
    EXPECT_THAT(job.value().header, HasSubstr("2 steps, 4 scenarios:"));
    EXPECT_TRUE(prepared(Trees::ForPosesOnly).value().trees.empty());
}

TEST_F(SceneJob, ExportsKnowItsBodiesAndSteps) {
    const auto job = prepared(Trees::ForPosesOnly);
    ASSERT_TRUE(job);
    const ExportContext context = export_context(job.value());
    ASSERT_EQ(context.bodies.size(), 3u);
    EXPECT_EQ(context.bodies[1].name, "car.1");
    EXPECT_EQ(context.bodies[1].file, "car.obj");
    EXPECT_FALSE(context.bodies[1].is_fixed);
    EXPECT_TRUE(context.bodies[2].is_fixed);
    EXPECT_TRUE(context.bodies[2].is_rounded);
    ASSERT_TRUE(context.steps);
    EXPECT_EQ(context.steps->steps(), 2u);
    EXPECT_EQ(context.steps->step_of(3), 1u);
}

TEST_F(SceneJob, IsSubmittedWithAllItsBodies) {
    const auto job = prepared(Trees::ForPosesOnly);
    ASSERT_TRUE(job);
    const Submit submit = submission_of(job.value());
    ASSERT_EQ(submit.bodies.size(), 3u);
    EXPECT_EQ(submit.bodies[1].name, "car.1");
    EXPECT_THAT(submit.bodies[1].file, HasSubstr("car.obj"));
    EXPECT_EQ(submit.bodies[0].mesh, submit.bodies[1].mesh);
    EXPECT_NE(submit.bodies[0].mesh, submit.bodies[2].mesh);
    EXPECT_EQ(submit.scenarios, 4u);
    EXPECT_EQ(submit.poses.kind, PosesKind::File);
    EXPECT_THAT(submit.poses.file, HasSubstr("poses.csv"));
    EXPECT_EQ(submit.query.ignored.size(), 1u);
}

} // namespace cd::tests
