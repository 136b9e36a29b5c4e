// Proves that the clearance with a chord is never below the sum of both, and that a chord that does
// not cover the rounding of the keys is refused.
#include "client/job/job_path.hpp"

#include "client/spec/job_file.hpp"
#include "client/spec/query_spec.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Prepares the keys and the motions of a box along a line that begins `from` metres away.
Result<PreparedJob> prepare(double from, const std::string& motion) {
    PreparedJob job;
    job.spec = CD_TRY(parse_job("[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\nline = { "
                                "from = [" +
                                    std::to_string(from) + ", 0, 0], to = [0, 0, 0] }\n[motion]\n" +
                                    motion,
                                "job.toml"));
    job.query = job.spec.query;
    job.meshes.assign(2, share(make_gridded_box(Vec3(1, 1, 1), 1)));
    CD_TRY(make_keys(job, std::get<CurveSpec>(job.spec.poses)));
    CD_TRY(make_path(job));
    return job;
}

std::string problem_with(double from, const std::string& motion) {
    const auto job = prepare(from, motion);
    return job ? "none" : job.error().detail;
}

} // namespace

TEST(JobPath, TheClearanceWithAChordIsNotBelowTheirSum) {
    EXPECT_EQ(with_chord(0, 0.1), 0.1);
    EXPECT_EQ(with_chord(1, 0x1p-60), 1 + 0x1p-52);
    EXPECT_EQ(with_chord(0x1p-60, 1), 1 + 0x1p-52);
    EXPECT_EQ(with_chord(0.5, 0.25), 0.75);
    std::mt19937_64 random(3);
    int raised = 0;
    for (int round = 0; round < 1000; ++round) {
        const double l = std::ldexp(uniform(random, 1, 2), static_cast<int>(round % 60) - 30);
        const double r = uniform(random, 1, 2);
        const double sum = with_chord(l, r);
        // The sum of two such doubles has at most 53 + 31 bits, so it is exact as two parts.
        const double rest = std::abs(l) > std::abs(r) ? (sum - l) - r : (sum - r) - l;
        EXPECT_GE(rest, 0) << l << " " << r;
        raised += sum > l + r ? 1 : 0;
    }
    EXPECT_GT(raised, 300);
    EXPECT_LT(raised, 700);
}

TEST(JobPath, TheWarningsSayHowFarKeysAreFromTheCurve) {
    const auto job = prepare(3, "resolution = 0.01\nchord = 0.001\n");
    ASSERT_TRUE(job) << job.error().detail;
    ASSERT_EQ(job.value().warnings.size(), 2u);
    EXPECT_THAT(job.value().warnings[0], HasSubstr("within 0.001 m, by which the clearance grows"));
    EXPECT_THAT(job.value().warnings[1], HasSubstr("rounding moved the bodies by at most"));
    EXPECT_EQ(job.value().labels.times.size(), job.value().poses->count());
    EXPECT_EQ(job.value().labels.end_times.back(), 1);
}

TEST(JobPath, AChordBelowTheRoundingOfKeysIsRefused) {
    EXPECT_THAT(
        problem_with(3, "resolution = 0.01\nchord = 1e-16\n"),
        HasSubstr("job.toml:6: [poses] line: numbers of 64 bits do not tell the curve within "
                  "1e-16"));
    // A kilometre away the grid of keys is wider than the roundings of the curve.
    EXPECT_THAT(problem_with(1000.3, "resolution = 0.01\nchord = 1e-9\n"),
                HasSubstr("job.toml:9: [motion]: chord = 1e-09 is too small, since rounding"));
    EXPECT_EQ(problem_with(1000.3, "resolution = 0.01\nchord = 1e-6\n"), "none");
}

} // namespace cd::tests
