// Proves that poses between rounded keys have no rounding error, that keys move by no more than is
// said, and that what is no key is refused.

#include "common/motion/motion_keys.hpp"

#include "common/motion/key_grid.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace cd::tests {

namespace {

std::vector<double> numbers_of(const Pose& pose) {
    const Quaternion& q = pose.quaternion();
    const Vec3& c = pose.translation();
    return {q.w, q.x, q.y, q.z, c.x(), c.y(), c.z()};
}

/// Whether each number is (1 - tau) from + tau to, exactly, at tau = index / 2^level.
bool is_between(
    const Pose& pose, const Pose& from, const Pose& to, std::uint32_t index, unsigned level) {
    const mpq_class tau = mpq_class(index) / (mpz_class(1) << level);
    const std::vector<double> of_pose = numbers_of(pose);
    const std::vector<double> of_from = numbers_of(from);
    const std::vector<double> of_to = numbers_of(to);
    for (std::size_t i = 0; i < of_pose.size(); ++i) {
        const mpq_class exact = (1 - tau) * mpq_class(of_from[i]) + tau * mpq_class(of_to[i]);
        if (exact != mpq_class(of_pose[i])) {
            return false;
        }
    }
    return true;
}

/// Makes keys that are each turned by less than 120 degrees against the one before.
std::vector<PosePair> random_keys(std::mt19937_64& random, std::size_t count, double reach) {
    std::vector<PosePair> keys{{make_pose(random, reach), make_pose(random, reach)}};
    while (keys.size() < count) {
        const auto next = [&](const Pose& pose) {
            return key_after(
                pose, uniform(random, 0, 120), random_axis(random), random_point(random, reach));
        };
        const Pose a = next(keys.back().a);
        keys.push_back({a, next(keys.back().b)});
    }
    return keys;
}

TEST(RoundKeys, PosesBetweenThemAreExact) {
    for (SeededRandom random : seeds(60)) {
        const double resolution = std::pow(10, uniform(random, -4, 0));
        const double reach = random() % 2 == 0 ? 2 : 1e-3;
        const auto given = random_keys(random, 2, reach);
        const BodyRadii radii{1.5, 0.5};
        const auto rounded = round_keys(given, radii, resolution);
        ASSERT_TRUE(rounded) << rounded.error().detail;
        const PosePair& from = rounded.value().keys[0];
        const PosePair& to = rounded.value().keys[1];
        const auto motion = Motion::create(from, to, radii, resolution);
        ASSERT_TRUE(motion) << motion.error().detail;
        const unsigned level = motion.value().depth() + 1;
        EXPECT_EQ(level, rounded.value().bits);
        for (int i = 0; i < 20; ++i) {
            const auto index = static_cast<std::uint32_t>(random() >> (64 - level));
            const PosePair between = motion.value().at(index, level);
            EXPECT_TRUE(is_between(between.a, from.a, to.a, index, level));
            EXPECT_TRUE(is_between(between.b, from.b, to.b, index, level));
        }
        EXPECT_EQ(motion.value().at(0, 0), from);
    }
}

TEST(RoundKeys, NeighboursShareAKey) {
    for (SeededRandom random : seeds(20)) {
        const auto given = random_keys(random, 6, 1);
        const auto rounded = round_keys(given, {1, 1}, 1e-3);
        ASSERT_TRUE(rounded);
        const auto& keys = rounded.value().keys;
        ASSERT_EQ(keys.size(), given.size());
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
            const auto motion = Motion::create(keys[i], keys[i + 1], {1, 1}, 1e-3);
            ASSERT_TRUE(motion) << motion.error().detail;
            EXPECT_LT(motion.value().depth(), rounded.value().bits);
        }
        const auto again = round_keys(keys, {1, 1}, 1e-3);
        ASSERT_TRUE(again);
        EXPECT_EQ(again.value().bits, rounded.value().bits);
    }
}

TEST(RoundKeys, NoPointMovesFartherThanIsSaid) {
    for (SeededRandom random : seeds(40)) {
        auto given = random_keys(random, 3, 100);
        given[1].b = Pose::from_matrix(given[1].b.rotation(), given[1].b.translation());
        const BodyRadii radii{2, 3};
        const auto rounded = round_keys(given, radii, 1e-3);
        ASSERT_TRUE(rounded) << rounded.error().detail;
        const RoundedKeys& keys = rounded.value();
        EXPECT_LT(keys.moved.a, 1e-7);
        EXPECT_LT(keys.moved.b, 1e-7);
        double longest = 0;
        for (std::size_t i = 0; i < given.size(); ++i) {
            const Vec3 point = radii.b * random_axis(random);
            const double moved = (given[i].b.apply(point) - keys.keys[i].b.apply(point)).norm();
            longest = std::max(longest, moved);
        }
        EXPECT_LE(longest, keys.moved.b + 1e-13);
        EXPECT_GT(longest, 0);
    }
}

TEST(RoundKeys, TheNormOfAQuaternionChangesNothing) {
    const Quaternion q{2, -1, 0.5, 0.25};
    const auto scaled = [&](double factor) {
        return Pose::from_quaternion({factor * q.w, factor * q.x, factor * q.y, factor * q.z},
                                     {1, 2, 3});
    };
    const auto keys_of = [&](double factor) {
        const PosePair from{moved_pose({0, 0, 0}), scaled(factor)};
        const PosePair to{moved_pose({0, 0, 0}), scaled(1)};
        return round_keys(std::array{from, to}, {1, 1}, 0.1).value().keys;
    };
    for (const double factor : {0x1p-900, 0x1p-1, 0x1p+800}) {
        EXPECT_EQ(keys_of(factor), keys_of(1));
    }
}

TEST(RoundKeys, MatricesBecomeQuaternions) {
    for (SeededRandom random : seeds(200)) {
        const Pose matrix = make_matrix_pose(random, 1);
        const auto keys = round_keys(std::array{PosePair{matrix, Pose{}}}, {1, 1}, 1);
        ASSERT_TRUE(keys);
        const PosePair& key = keys.value().keys[0];
        EXPECT_EQ(key.b.quaternion(), Quaternion{});
        EXPECT_LT((key.a.rotation() - matrix.matrix()).norm(), 1e-14);
    }
    // Half turns about each axis have a component of 0.
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Mat3 half_turn = 2 * axis * axis.transpose() - Mat3::Identity();
        const Pose pose = Pose::from_matrix(half_turn, {0, 0, 0});
        const auto keys = round_keys(std::array{PosePair{pose, pose}}, {1, 1}, 1);
        ASSERT_TRUE(keys);
        EXPECT_EQ(keys.value().keys[0].a.rotation(), half_turn);
    }
}

void expect_refused(const PosePair& from, const PosePair& to, double resolution, ErrorCode code) {
    const auto keys = round_keys(std::array{from, to}, {1, 1}, resolution);
    ASSERT_FALSE(keys);
    EXPECT_EQ(keys.error().code, code) << keys.error().detail;
}

TEST(RoundKeys, WhatIsNoKeyIsRefused) {
    const Pose rest = moved_pose({0, 0, 0});
    const auto refuse = [&](const Pose& pose) {
        expect_refused({rest, rest}, {rest, pose}, 0.1, ErrorCode::BadInput);
    };
    refuse(Pose::from_matrix(1.01 * Mat3::Identity(), {0, 0, 0}));
    refuse(Pose::from_matrix(-Mat3::Identity(), {0, 0, 0}));
    refuse(Pose::from_matrix(Mat3::Zero(), {0, 0, 0}));
    refuse(moved_pose({std::numeric_limits<double>::quiet_NaN(), 0, 0}));
    refuse(moved_pose({0, std::numeric_limits<double>::infinity(), 0}));
    refuse(turned_pose(180, Vec3(0, 0, 1)));
    refuse(turned_pose(-180, Vec3(0, 1, 0)));
}

TEST(RoundKeys, AMotionThatNeedsTooManyHalvingsIsRefused) {
    const PosePair from{moved_pose({0, 0, 0}), moved_pose({0, 0, 0})};
    const PosePair to{moved_pose({0, 0, 0}), moved_pose({4, 0, 0})};
    // M of the whole is slightly more than 2.
    expect_refused(from, to, 0x1p-18, ErrorCode::TooLarge);
    EXPECT_EQ(make_motion(from, to, {1, 1}, 0x1p-18 * (1 + 0x1p-30)).depth(), 19u);
    for (const double resolution : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        expect_refused(from, to, resolution, ErrorCode::BadInput);
    }
}

TEST(Motion, TurnsTheShortWay) {
    const Pose rest = moved_pose({0, 0, 0});
    const Pose turned = turned_pose(90, Vec3(0, 0, 1));
    const Quaternion q = turned.quaternion();
    const Pose negative = Pose::from_quaternion({-q.w, -q.x, -q.y, -q.z}, {0, 0, 0});
    const Motion one = make_motion({rest, rest}, {rest, turned}, {1, 1}, 0.1);
    const Motion other = make_motion({rest, rest}, {rest, negative}, {1, 1}, 0.1);
    EXPECT_EQ(one.at(1, 1), other.at(1, 1));
    const Vec3 middle = one.at(1, 1).b.apply({1, 0, 0});
    EXPECT_LT((middle - Vec3(std::sqrt(0.5), std::sqrt(0.5), 0)).norm(), 1e-12);
}

TEST(Motion, AlmostAHalfTurnIsExactAndRigid) {
    const Pose rest = moved_pose({0, 0, 0});
    const Motion motion =
        make_motion({rest, rest}, {rest, turned_pose(179, Vec3(0, 0, 1))}, {1, 1}, 1e-3);
    const Vec3 middle = motion.at(1, 1).b.apply({1, 0, 0});
    EXPECT_NEAR(std::atan2(middle.y(), middle.x()), 179 * M_PI / 360, 1e-9);
    EXPECT_NEAR(middle.norm(), 1, 1e-14);
}

TEST(Motion, KeysOnTooFineAGridAreRefused) {
    const Pose rest = moved_pose({0, 0, 0});
    const PosePair from{rest, moved_pose({1.0 / 3, 0, 0})};
    const PosePair to{rest, moved_pose({1, 0, 0})};
    const auto motion = Motion::create(from, to, {1, 1}, 1e-3);
    ASSERT_FALSE(motion);
    EXPECT_EQ(motion.error().code, ErrorCode::BadInput);
    EXPECT_FALSE(Motion::create({rest, Pose{}}, to, {1, 1}, 1e-3)); // A matrix.
    const Pose long_one = Pose::from_quaternion({2, 0, 0, 0}, {0, 0, 0});
    EXPECT_FALSE(Motion::create({rest, long_one}, to, {1, 1}, 1e-3));
}

TEST(KeyGrid, ItsExponentIsTheLeast) {
    EXPECT_EQ(grid_exponent({0, 0, 0}), KeyGrid::exponent_min);
    EXPECT_EQ(grid_exponent({0.25, -1, 0.5}), 0);
    EXPECT_EQ(grid_exponent({0.25, -1.25, 0.5}), 1);
    EXPECT_EQ(grid_exponent({1000, 0, 0}), 10);
}

TEST(KeyGrid, HoldsWhatItRounds) {
    for (SeededRandom random : seeds(50)) {
        const Pose pose = make_pose(random, 1000);
        for (const unsigned bits : {1u, 7u, 13u, 20u}) {
            const KeyGrid grid{bits, grid_exponent(pose.translation())};
            const Pose rounded = grid.rounded(pose);
            EXPECT_TRUE(grid.holds(rounded));
            EXPECT_EQ(grid.rounded(rounded), rounded);
            EXPECT_FALSE((KeyGrid{bits + 12, grid.exponent}.holds(rounded)));
            EXPECT_FALSE((KeyGrid{bits, grid.exponent - 1}.holds(rounded)));
        }
    }
}

} // namespace

} // namespace cd::tests
