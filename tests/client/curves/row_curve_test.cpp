// Proves that keys between rows with velocities keep every point near the rows' curves, that fewer
// keys do not, and that rows that contradict each other are refused by their names.
#include "client/curves/row_curve.hpp"

#include "common/motion/body_path.hpp"
#include "common/motion/motion_keys.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cd::tests {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double degree = 3.14159265358979323846 / 180;

CurvePhase phase_of(const Pose& from, const PoseRates& rates, double seconds) {
    const Pose key = unit_key(from).value();
    CurvePhase phase;
    phase.seconds = seconds;
    phase.turn = key.quaternion();
    phase.spin = rates.spin;
    phase.from = key.translation();
    phase.velocity = rates.velocity;
    phase.acceleration = rates.acceleration;
    return phase;
}

const PoseRates braking{Vec3(12, 0, 0), Vec3(-4, 1, 0), Vec3(0.1, 0, 80 * degree)};
const PoseRates rising{Vec3(0, 0, 1), Vec3(0, 2, 0), Vec3(0, 300 * degree, 0)};

/// Returns rows of which each goes on where the one before led: B brakes, then it rises, and A
/// rises all the time. `gap` moves B in the second row.
std::vector<KeyRow> some_rows(const Vec3& gap = Vec3::Zero()) {
    std::vector<KeyRow> rows(3);
    rows[0] = {10, {moved_pose(Vec3(0, 5, 0)), moved_pose(Vec3(1, 2, 3))}, {rising, braking}};
    rows[1].time = 12;
    rows[1].poses = {phase_of(rows[0].poses.a, rising, 2).at(2),
                     phase_of(rows[0].poses.b, braking, 2).at(2)};
    rows[1].poses.b =
        Pose::from_quaternion(rows[1].poses.b.quaternion(), rows[1].poses.b.translation() + gap);
    rows[1].rates = {rising, rising};
    rows[2].time = 12.5;
    rows[2].poses = {phase_of(rows[1].poses.a, rising, 0.5).at(0.5),
                     phase_of(rows[1].poses.b, rising, 0.5).at(0.5)};
    return rows;
}

/// Returns the same rows with A at rest.
std::vector<KeyRow> rows_of_b() {
    std::vector<KeyRow> rows = some_rows();
    for (KeyRow& row : rows) {
        row.poses.a = Pose();
        row.rates[0] = {};
    }
    return rows;
}

const Mesh body = make_box(Vec3(1, 2, 3));
const double radius = body_radius(body.vertices());

std::string row_name(std::size_t row) {
    return "line " + std::to_string(row + 2);
}

Result<RowKeys> keys_of(const std::vector<KeyRow>& rows, std::size_t moving, double off_max) {
    return keys_between(rows, {radius, radius}, moving, off_max, row_name);
}

std::string problem_with(const std::vector<KeyRow>& rows, double off_max = 1e-3) {
    const auto keys = keys_of(rows, 2, off_max);
    return keys ? "none" : keys.error().detail;
}

/// Returns how far the motion from one pose to another takes a body's corners from a curve, of
/// which it passes the times from `begin` to `end`.
double
deviation_of(const Pose& from, const Pose& to, const CurvePhase& curve, double begin, double end) {
    const BodyPath path = path_between(unit_key(from).value(), unit_key(to).value()).value();
    double largest = 0;
    for (int step = 0; step <= 32; ++step) {
        const double tau = step / 32.0;
        const Pose moved = pose_at(path, tau);
        const Pose right = curve.at(begin + tau * (end - begin));
        for (const Vec3& vertex : body.vertices()) {
            largest = std::max(largest, (moved.apply(vertex) - right.apply(vertex)).norm());
        }
    }
    return largest;
}

/// Returns by how much the motions between every `step`-th key, and those of the rows, change the
/// distances of A's and B's corners at most.
double largest_error(const std::vector<KeyRow>& rows, const RowKeys& keys, std::size_t step = 1) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < keys.poses.size();) {
        const std::size_t row = keys.rows[i];
        std::size_t next = i + 1;
        while (next - i < step && keys.rows[next] == row) {
            ++next;
        }
        const KeyRow& from = rows[row];
        const double seconds = rows[row + 1].time - from.time;
        const double begin = keys.times[i] - from.time;
        const double end = keys.times[next] - from.time;
        const PosePair& left = keys.poses[i];
        const PosePair& right = keys.poses[next];
        largest = std::max(
            largest,
            deviation_of(
                left.a, right.a, phase_of(from.poses.a, from.rates[0], seconds), begin, end) +
                deviation_of(
                    left.b, right.b, phase_of(from.poses.b, from.rates[1], seconds), begin, end));
        i = next;
    }
    return largest;
}

} // namespace

TEST(RowCurve, KeysKeepEveryPointNearTheCurves) {
    for (const double off_max : {1e-1, 1e-3, 1e-5}) {
        // Half of what is allowed is taken by the gap between a curve and the next row.
        for (const Vec3& gap : {Vec3(0, 0, 0), Vec3(0, 0.49 * off_max, 0)}) {
            const std::vector<KeyRow> rows = some_rows(gap);
            const auto keys = keys_of(rows, 2, off_max);
            ASSERT_TRUE(keys) << keys.error().detail;
            EXPECT_LE(largest_error(rows, keys.value()), off_max);
            EXPECT_EQ(keys.value().times.front(), 10);
            EXPECT_EQ(keys.value().times.back(), 12.5);
            EXPECT_TRUE(std::ranges::is_sorted(keys.value().rows));
        }
    }
    const std::vector<KeyRow> rows = some_rows();
    EXPECT_GT(largest_error(rows, keys_of(rows, 2, 1e-5).value(), 10), 1e-5);
}

TEST(RowCurve, ThePosesOfTheRowsAreKeys) {
    const std::vector<KeyRow> rows = some_rows(Vec3(0, 0, 1e-4));
    const RowKeys keys = keys_of(rows, 2, 1e-3).value();
    for (const KeyRow& row : rows) {
        const auto found = std::ranges::find(keys.times, row.time);
        ASSERT_NE(found, keys.times.end());
        EXPECT_EQ(keys.poses[static_cast<std::size_t>(found - keys.times.begin())], row.poses);
    }
    EXPECT_EQ(keys.rows.front(), 0u);
    EXPECT_EQ(keys.rows.back(), 2u);
}

TEST(RowCurve, ABodyAtRestKeepsItsPoseAndAsksForNoKeys) {
    const std::vector<KeyRow> rows = rows_of_b();
    const auto made = keys_of(rows, 1, 1e-3);
    ASSERT_TRUE(made) << made.error().detail;
    const RowKeys& keys = made.value();
    EXPECT_TRUE(
        std::ranges::all_of(keys.poses, [](const PosePair& poses) { return poses.a == Pose(); }));
    EXPECT_LT(keys.poses.size(), keys_of(some_rows(), 2, 1e-3).value().poses.size());
    EXPECT_LE(largest_error(rows, keys), 1e-3);
    // A curve that is straight has the rows alone as keys.
    std::vector<KeyRow> straight(2);
    straight[0].rates[1].velocity = Vec3(3, 0, 0);
    straight[1] = {1, {Pose(), moved_pose(Vec3(3, 0, 0))}, {}};
    EXPECT_EQ(keys_of(straight, 1, 1e-9).value().poses.size(), 2u);
}

TEST(RowCurve, TurnsOfMoreThanAHalfAreFollowed) {
    std::vector<KeyRow> rows(2);
    rows[0].rates[1].spin = Vec3(0, 0, 720 * degree);
    rows[1].time = 1;
    const auto made = keys_of(rows, 1, 0.1);
    ASSERT_TRUE(made) << made.error().detail;
    const RowKeys& keys = made.value();
    EXPECT_GE(keys.poses.size(), 9u);
    EXPECT_LE(largest_error(rows, keys), 0.1);
}

TEST(RowCurve, RowsThatContradictEachOtherAreRefused) {
    EXPECT_EQ(problem_with(some_rows(Vec3(0, 0.00049, 0))), "none");
    EXPECT_THAT(problem_with(some_rows(Vec3(0, 0.00051, 0))),
                StartsWith("line 3: the velocities of the row before miss this pose by up to "
                           "0.00051, more than half of 0.001; "));
    std::vector<KeyRow> turned = some_rows();
    turned[2].poses.b = turned[1].poses.b;
    EXPECT_THAT(problem_with(turned), StartsWith("line 4: the velocities of the row before miss"));
    std::vector<KeyRow> late = some_rows();
    late[2].time = 12;
    EXPECT_EQ(problem_with(late), "line 4: the time 12 is not after 12 of line 3");
}

TEST(RowCurve, WhatCannotBeFollowedIsRefused) {
    EXPECT_THAT(problem_with(some_rows(), 1e-12), HasSubstr("line 2: numbers of 64 bits do not"));
    std::vector<KeyRow> rows(2);
    rows[0].rates[1].spin = Vec3(0, 0, 1e7);
    rows[1].time = 1;
    rows[1].poses.b =
        phase_of(Pose::from_quaternion({1, 0, 0, 0}, Vec3::Zero()), rows[0].rates[1], 1).at(1);
    EXPECT_THAT(problem_with(rows), StartsWith("line 2: the curve takes more than 1e+06 keys"));
}

} // namespace cd::tests
