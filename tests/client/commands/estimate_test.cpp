// Proves that a run can be estimated however slow its poses and scenarios are.
#include "client/commands/estimate.hpp"

#include "client/spec/job_options.hpp"
#include "tests/support/obj_file.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

TEST(Estimate, WhereNoTimeIsLeftOneScenarioTellsTimeAndSize) {
    const TemporaryFolder folder;
    write_obj(folder / "a.obj", make_torus(1.0, 0.4, 24, 12));
    write_obj(folder / "b.obj", make_sphere(1));
    JobOptions options;
    options.a = folder / "a.obj";
    options.b = folder / "b.obj";
    options.random = 300;
    options.out = folder / "out";
    auto spec = make_job_spec(options);
    ASSERT_TRUE(spec);
    TreeCache cache{std::filesystem::path()};
    ThreadPool pool(2);
    const auto job = prepare_job(std::move(spec.value()), Trees::Always, cache, pool);
    ASSERT_TRUE(job);

    EstimateOptions no_time;
    no_time.time_max = std::chrono::milliseconds(0);
    const auto estimate = estimate_run(job.value(), pool, no_time);
    ASSERT_TRUE(estimate) << estimate.error().detail;
    EXPECT_EQ(estimate.value().sampled, 1u);
    EXPECT_GT(estimate.value().seconds, 0);
    EXPECT_GT(estimate.value().bytes, 0u);
}

} // namespace cd::tests
