// Proves that a run can be estimated however slow its poses and scenarios are, and that its samples
// represent the whole job.
#include "client/commands/estimate.hpp"

#include "client/spec/job_options.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

/// Estimates a job of a torus and a sphere.
RunEstimate estimate(const PosesSpec& poses, const EstimateOptions& how) {
    const TemporaryFolder folder;
    JobOptions options;
    options.poses.random = 1;
    write_obj(folder / "a.obj", make_torus(1.0, 0.4, 24, 12));
    write_obj(folder / "b.obj", make_sphere(1));
    options.a = folder / "a.obj";
    options.b = folder / "b.obj";
    options.output.dir = folder / "out";
    auto spec = make_job_spec(options);
    spec.value().poses = poses;
    TreeCache cache{std::filesystem::path()};
    ThreadPool pool(2);
    const auto job = prepare_job(std::move(spec.value()), Trees::Always, cache, pool);
    return estimate_run(job.value(), pool, how).value();
}

} // namespace

TEST(Estimate, WhereNoTimeIsLeftOneScenarioTellsTimeAndSize) {
    RandomPoses poses;
    poses.count = 300;
    EstimateOptions no_time;
    no_time.time_max = std::chrono::milliseconds(0);
    const RunEstimate one = estimate(poses, no_time);
    EXPECT_EQ(one.sampled, 1u);
    EXPECT_GT(one.seconds, 0);
    EXPECT_GT(one.bytes, 0u);
}

// Half of the grid's poses touch: those with an even index. Samples at equal steps of two would
// meet only one half.
TEST(Estimate, SamplesOfAGridMeetAllValuesOfItsFastestAxis) {
    GridSpec grid;
    grid.grid.position = {GridAxis{0, 0.001, 1000}, GridAxis{}, GridAxis{0, 1000, 2}};
    EstimateOptions how;
    how.samples_max = 1000;
    const RunEstimate half = estimate(grid, how);
    ASSERT_EQ(half.sampled, 1000u);
    how.samples_max = 2000;
    const RunEstimate all = estimate(grid, how);
    ASSERT_EQ(all.sampled, 2000u);
    EXPECT_GT(half.triangle_tests, 0.8 * all.triangle_tests);
    EXPECT_LT(half.triangle_tests, 1.2 * all.triangle_tests);
}

} // namespace cd::tests
