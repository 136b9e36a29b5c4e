// Proves that keys along a curve keep every point of the body within the distance asked for, that a
// tenth of the keys does not, and that curves are what their numbers say.
#include "client/curves/pose_curve.hpp"

#include "common/motion/body_path.hpp"
#include "common/motion/motion_keys.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

CurvePhase arc() {
    CurvePhase phase;
    phase.spin = Vec3(0, 0, 90 * degree);
    phase.from = Vec3(2, 0, 0);
    phase.pivot = Vec3::Zero();
    return phase;
}

CurvePhase screw() {
    CurvePhase phase;
    phase.spin = Vec3(0, 0, 1080 * degree);
    phase.velocity = Vec3(0, 0, 0.006);
    phase.pivot = Vec3::Zero();
    return phase;
}

CurvePhase drive() {
    CurvePhase phase;
    phase.seconds = 2;
    phase.velocity = Vec3(12, 0, 0);
    phase.acceleration = Vec3(-4, 1, 0);
    phase.spin = Vec3(0.1, 0, 10 * degree);
    return phase;
}

/// Returns how far the motions between the keys take the corners of a box from the curve.
double largest_error(const CurvePhase& phase, const CurveKeys& keys, const Mesh& body) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < keys.poses.size(); ++i) {
        const BodyPath path = path_between(keys.poses[i], keys.poses[i + 1]).value();
        for (int step = 0; step <= 32; ++step) {
            const double tau = step / 32.0;
            const Pose moved = pose_at(path, tau);
            const Pose right = phase.at(keys.times[i] + tau * (keys.times[i + 1] - keys.times[i]));
            for (const Vec3& vertex : body.vertices()) {
                const Vec3 off = moved.rotation() * vertex + moved.translation() -
                                 (right.rotation() * vertex + right.translation());
                largest = std::max(largest, off.norm());
            }
        }
    }
    return largest;
}

/// Leaves every `step`-th key, and the last.
CurveKeys thinned(const CurveKeys& keys, std::size_t step) {
    CurveKeys few;
    for (std::size_t i = 0; i < keys.poses.size(); i += step) {
        few.poses.push_back(keys.poses[i]);
        few.times.push_back(keys.times[i]);
    }
    return few;
}

} // namespace

TEST(PoseCurve, KeysKeepEveryPointNearTheCurve) {
    const Mesh body = make_box(Vec3(1, 2, 3));
    const double radius = body_radius(body.vertices());
    for (const CurvePhase& phase : {arc(), screw(), drive()}) {
        for (const double off_max : {1e-1, 1e-3, 1e-5}) {
            const auto keys = keys_along({phase}, radius, off_max);
            ASSERT_TRUE(keys) << keys.error().detail;
            EXPECT_EQ(keys.value().times.front(), 0);
            EXPECT_EQ(keys.value().times.back(), phase.seconds);
            EXPECT_LE(largest_error(phase, keys.value(), body), off_max);
        }
        const CurveKeys many = keys_along({phase}, radius, 1e-5).value();
        EXPECT_GT(largest_error(phase, thinned(many, 10), body), 1e-5);
    }
}

TEST(PoseCurve, AStraightLineHasTwoKeys) {
    CurvePhase line;
    line.from = Vec3(1, 2, 3);
    line.velocity = Vec3(3, 0, 0);
    const CurveKeys keys = keys_along({line}, 100, 1e-9).value();
    ASSERT_EQ(keys.poses.size(), 2u);
    EXPECT_EQ(keys.poses[1].translation(), Vec3(4, 2, 3));
    // A hinge turns where it is.
    CurvePhase hinge = screw();
    hinge.velocity = Vec3::Zero();
    const CurveKeys turn = keys_along({hinge}, 1, 1e-3).value();
    for (const Pose& pose : turn.poses) {
        EXPECT_EQ(pose.translation(), Vec3::Zero());
    }
}

TEST(PoseCurve, PhasesFollowEachOther) {
    CurvePhase second = drive();
    second.from = Vec3(16, 2, 0);
    const CurveKeys keys = keys_along({drive(), second}, 1, 0.1).value();
    for (std::size_t i = 0; i + 1 < keys.times.size(); ++i) {
        EXPECT_LT(keys.times[i], keys.times[i + 1]);
    }
    EXPECT_EQ(keys.times.back(), 4);
    const Pose end = arc().at(1);
    EXPECT_NEAR((end.translation() - Vec3(0, 2, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((end.rotation() * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 0, 1e-15);
}

TEST(PoseCurve, PartOfTheDistanceIsLeftForTheGrid) {
    const Mesh body = make_box(Vec3(1, 2, 3));
    const double radius = body_radius(body.vertices());
    for (const CurvePhase& phase : {arc(), screw(), drive()}) {
        const auto keys = keys_along({phase}, radius, 1e-3);
        ASSERT_TRUE(keys);
        const double error = largest_error(phase, keys.value(), body);
        EXPECT_LE(error, (1 - grid_share) * 1e-3);
        EXPECT_GT(error, 1e-4) << "not far more keys than needed";
    }
}

TEST(PoseCurve, TooManyKeysAreRefused) {
    CurvePhase fast;
    fast.spin = Vec3(0, 0, 2e6);
    const auto keys = keys_along({fast}, 1, 1);
    ASSERT_FALSE(keys);
    EXPECT_EQ(keys.error().code, ErrorCode::TooLarge);
}

TEST(PoseCurve, LessThanTheRoundingOfNumbersIsRefused) {
    for (const CurvePhase& phase : {arc(), screw(), drive()}) {
        const auto keys = keys_along({phase}, 1, 1e-15);
        ASSERT_FALSE(keys);
        EXPECT_EQ(keys.error().code, ErrorCode::BadInput);
    }
    CurvePhase far;
    far.from = Vec3(1e9, 0, 0);
    EXPECT_FALSE(keys_along({far}, 1, 1e-5));
    EXPECT_TRUE(keys_along({far}, 1, 1e-4));
}

} // namespace cd::tests
