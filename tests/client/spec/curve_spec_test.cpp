// Proves that curves are read as they are written, that the text of a job reads the same, and that
// a curve that is none is refused where it stands.
#include "client/job/job_text.hpp"
#include "client/job/submission.hpp"
#include "client/spec/job_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace cd::tests {

namespace {

using testing::HasSubstr;

/// Makes a job whose [poses] begin in line 5 and whose [motion] follows.
Result<JobSpec> read(const std::string& poses,
                     const std::string& more = "[motion]\nresolution = 0.5\n") {
    return parse_job("[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n[poses]\n" + poses + more,
                     "job.toml");
}

std::string problem_with(const std::string& poses,
                         const std::string& more = "[motion]\nresolution = 0.5\n") {
    const auto spec = read(poses, more);
    return spec ? "none" : spec.error().detail;
}

CurveSpec curve_of(const std::string& poses) {
    const auto spec = read(poses);
    EXPECT_TRUE(spec) << (spec ? "" : spec.error().detail);
    return spec ? std::get<CurveSpec>(spec.value().poses) : CurveSpec{};
}

Vec3 place(const CurvePhase& phase, double time) {
    return phase.at(time).translation();
}

void expect_near(const Vec3& given, const Vec3& expected) {
    EXPECT_NEAR((given - expected).norm(), 0, 1e-12) << given.transpose();
}

const std::string line = "line = { from = [0, 0, 0], to = [3, 0, 0], yaw_deg = [0, 30] }\n";
const std::string arc =
    "arc = { origin = [1, 0, 0], axis = [0, 0, 2], degrees = [0, 90], start = [3, 0, 0] }\n";
const std::string screw = "screw = { axis = [0, 0, 1], degrees = [90, 450], pitch = 0.5 }\n";
const std::string drives =
    "drive = [{ start = [1, 0, 0], velocity = [12, 0, 0], acceleration = [-4, 0, 0], seconds = 2 "
    "}, { spin_deg = [0, 0, 45], seconds = 1 }]\n";

} // namespace

TEST(CurveSpec, GoesWhereItsNumbersSay) {
    const CurvePhase straight = curve_of(line).phases.at(0);
    expect_near(place(straight, 0.5), Vec3(1.5, 0, 0));
    expect_near(straight.at(1).rotation() * Vec3(2, 0, 0), Vec3(std::sqrt(3.0), 1, 0));
    const CurvePhase round = curve_of(arc).phases.at(0);
    expect_near(place(round, 0), Vec3(3, 0, 0));
    expect_near(place(round, 1), Vec3(1, 2, 0));
    expect_near(round.at(1).rotation() * Vec3(1, 0, 0), Vec3(0, 1, 0));
    const CurvePhase thread = curve_of(screw).phases.at(0);
    expect_near(place(thread, 0), Vec3(0, 0, 0.125));
    expect_near(place(thread, 1), Vec3(0, 0, 0.625));
    expect_near(thread.at(0).rotation() * Vec3(1, 0, 0), Vec3(0, 1, 0));
    const CurveSpec driven = curve_of(drives);
    ASSERT_EQ(driven.phases.size(), 2u);
    expect_near(place(driven.phases[0], 2), Vec3(17, 0, 0));
    expect_near(place(driven.phases[1], 0), Vec3(17, 0, 0));
    expect_near(place(driven.phases[1], 1), Vec3(21, 0, 0)); // At 4 m/s, no longer braking.
    const CurvePhase in_mm = curve_of("unit = \"mm\"\n" + line).phases.at(0);
    expect_near(place(in_mm, 1), Vec3(0.003, 0, 0));
}

TEST(CurveSpec, ReadsTheSameFromItsOwnText) {
    for (const std::string& poses : {line, arc, screw, drives, "unit = \"mm\"\n" + line}) {
        const auto spec = read(poses, "[motion]\nresolution = 0.5\nchord = 0.25\n");
        ASSERT_TRUE(spec) << spec.error().detail;
        EXPECT_EQ(spec.value().chord, 0.25);
        const auto again = parse_job(job_text(spec.value()), "job.toml");
        ASSERT_TRUE(again) << again.error().detail;
        EXPECT_EQ(again.value().chord, 0.25);
        EXPECT_EQ(job_text(again.value()), job_text(spec.value()));
        const CurveSpec& curve = std::get<CurveSpec>(spec.value().poses);
        Submit submit;
        submit.bodies = {{}, {}};
        submit.query = spec.value().query;
        submit.unit = "m";
        submit.poses.kind = PosesKind::Curve;
        submit.poses.file = curve.text;
        submit.poses.unit = curve.unit;
        const auto from_master = spec_of(submit);
        ASSERT_TRUE(from_master) << from_master.error().detail;
        const CurveSpec& rebuilt = std::get<CurveSpec>(from_master.value().poses);
        ASSERT_EQ(rebuilt.phases.size(), curve.phases.size());
        for (std::size_t i = 0; i < curve.phases.size(); ++i) {
            EXPECT_EQ(rebuilt.phases[i].at(0.5), curve.phases[i].at(0.5));
        }
    }
}

TEST(CurveSpec, WhatIsNoCurveIsRefusedWhereItStands) {
    EXPECT_THAT(problem_with("line = { from = [0, 0, 0] }\n"),
                HasSubstr("job.toml:6: [poses] line: to = [x, y, z] is missing"));
    EXPECT_THAT(problem_with("arc = { axis = [0, 0, 0], degrees = [0, 9], start = [1, 0, 0] }\n"),
                HasSubstr("axis has no direction"));
    EXPECT_THAT(problem_with("screw = { axis = [0, 0, 1], degrees = [0, 9] }\n"),
                HasSubstr("pitch is missing"));
    EXPECT_THAT(problem_with("drive = { velocity = [1, 0, 0] }\n"),
                HasSubstr("seconds is a number above 0"));
    EXPECT_THAT(problem_with("drive = []\n"), HasSubstr("drive is empty"));
    EXPECT_THAT(problem_with("line = { from = [0, 0, 0], to = [1e308, 0, 0] }\nunit = \"km\"\n"),
                HasSubstr("leaves the range"));
    EXPECT_THAT(problem_with(line + arc), HasSubstr("exactly one of file, grid, random, line"));
    EXPECT_THAT(problem_with(line, ""), HasSubstr("a curve has no poses of its own"));
}

TEST(CurveSpec, ChordAndStepsBelongToTheirKinds) {
    const std::string file = "file = \"keys.csv\"\n";
    EXPECT_EQ(problem_with(line + "max_step = 0.1\n", ""), "none");
    EXPECT_EQ(problem_with(file + "max_step = 0.1\n", ""), "none");
    EXPECT_THAT(problem_with(line + "max_step = 0\n", ""), HasSubstr("max_step is a length above"));
    EXPECT_THAT(problem_with(line + "max_step = 0.1\n"), HasSubstr("leave it out with [motion]"));
    EXPECT_THAT(problem_with("random = { n = 5 }\nmax_step = 0.1\n", ""),
                HasSubstr("poses of another kind"));
    // Whether a file has velocities is known once it is read.
    EXPECT_EQ(problem_with(file, "[motion]\nresolution = 1\nchord = 1\n"), "none");
    EXPECT_THAT(problem_with(line, "[motion]\nresolution = 1\nchord = 0\n"),
                HasSubstr("chord is a length above 0"));
}

} // namespace cd::tests
