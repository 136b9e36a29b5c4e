// Proves that no two points of two moving bodies come closer to each other, or part, by more than
// the bound of a cell, compared in integers; and that the bound is not much larger than it must be.

#include "common/motion/motion_bound.hpp"

#include "tests/support/motion_oracle.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace cd::tests {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned instants_level = 24;

enum class Kind { Anything, Translation, Hinge, Together, AlmostTogether, HalfTurn, Slow, Far };
constexpr std::array kinds{Kind::Anything,
                           Kind::Translation,
                           Kind::Hinge,
                           Kind::Together,
                           Kind::AlmostTogether,
                           Kind::HalfTurn,
                           Kind::Slow,
                           Kind::Far};

struct Keys {
    PosePair from;
    PosePair to;
};

Keys make_keys(Kind kind, std::mt19937_64& random) {
    const double reach = kind == Kind::Far ? 1e6 : 3;
    Keys keys{{make_pose(random, reach), make_pose(random, 3)}, {}};
    const Vec3 axis = random_axis(random);
    const Vec3 move = random_point(random, 2);
    const auto after = [&](const Pose& pose, double degrees, const Vec3& by) {
        return key_after(pose, degrees, axis, by);
    };
    const Pose& a = keys.from.a;
    const Pose& b = keys.from.b;
    switch (kind) {
    case Kind::Anything:
    case Kind::Far:
        keys.to = {key_after(a, uniform(random, 0, 170), random_axis(random), move),
                   after(b, uniform(random, 0, 170), random_point(random, 2))};
        break;
    case Kind::Translation:
        keys.to = {after(a, 0, move), after(b, 0, random_point(random, 2))};
        break;
    case Kind::Hinge:
        keys.to = {a, after(b, uniform(random, 0, 120), Vec3::Zero())};
        break;
    case Kind::Together:
    case Kind::AlmostTogether: {
        const double degrees = uniform(random, 0, 40);
        const double more = kind == Kind::Together ? 0 : 1e-6;
        // B is carried around A's origin.
        const Vec3 arm = b.translation() - a.translation();
        const Vec3 carried = turned_pose(degrees, axis).apply(arm) - arm;
        keys.to = {after(a, degrees, move), after(b, degrees + more, move + carried + more * axis)};
        break;
    }
    case Kind::HalfTurn:
        keys.to = {after(a, -179, Vec3::Zero()), after(b, 179, move)};
        break;
    case Kind::Slow:
        keys.to = {after(a, 1e-7, 1e-9 * move), after(b, 1e-8, 1e-10 * move)};
        break;
    }
    return keys;
}

/// A point of A, and one of B that is where it is at tau = instant / 2^instants_level.
struct Meeting {
    Vec3 x;
    Vec3 y;
    std::uint64_t instant;
};

Meeting make_meeting(const BodyPath& a, const BodyPath& b, std::mt19937_64& random) {
    Meeting meeting{random_point(random, 2), {}, random() >> (64 - instants_level)};
    const double tau = std::ldexp(static_cast<double>(meeting.instant), -int{instants_level});
    const Pose of_b = pose_at(b, tau);
    const Vec3 point = pose_at(a, tau).apply(meeting.x);
    meeting.y = of_b.rotation().transpose() * (point - of_b.translation());
    return meeting;
}

/// Two moving bodies whose vertices meet.
struct MeetingBodies {
    explicit MeetingBodies(const Keys& keys, std::mt19937_64& random)
        : a(path_between(keys.from.a, keys.to.a).value()),
          b(path_between(keys.from.b, keys.to.b).value()) {
        std::vector<Vec3> points_a;
        std::vector<Vec3> points_b;
        for (int i = 0; i < 40; ++i) {
            meetings.push_back(make_meeting(a, b, random));
            points_a.push_back(meetings.back().x);
            points_b.push_back(meetings.back().y);
        }
        radii = {body_radius(points_a), body_radius(points_b)};
    }

    BodyPath a;
    BodyPath b;
    std::vector<Meeting> meetings;
    BodyRadii radii;
};

/// The keys on the grid, so that poses at the middles of cells are exact.
Keys on_grid(const Keys& keys) {
    const auto rounded = round_keys(std::array{keys.from, keys.to}, {1, 1}, 1e-3);
    EXPECT_TRUE(rounded);
    return {rounded.value().keys[0], rounded.value().keys[1]};
}

struct Counts {
    std::uint64_t checks = 0;
    std::uint64_t wrong = 0;
    std::uint64_t wrong_if_smaller = 0; ///< With 0.3 M.
    std::uint64_t tight = 0;            ///< Wrong with 0.7 M.
};

void check_meeting(const MeetingBodies& bodies,
                   const OraclePath& a,
                   const OraclePath& b,
                   const Meeting& meeting,
                   Counts& counts) {
    const auto apart = [&](std::uint64_t index, unsigned level) {
        return distance(a.place(meeting.x, index, level), b.place(meeting.y, index, level));
    };
    const ExactLength at_meeting = apart(meeting.instant, instants_level);
    double bound = infinity;
    for (unsigned level = 0; level < 8; ++level) {
        const auto index = static_cast<std::uint32_t>(meeting.instant >> (instants_level - level));
        const TimeCell cell{level, index};
        bound = cell_bound(bodies.a, bodies.b, bodies.radii, cell, bound);
        const ExactLength at_middle = apart(2 * std::uint64_t{index} + 1, level + 1);
        for (const ExactLength& other : {at_meeting, apart(index, level)}) {
            ++counts.checks;
            counts.wrong += differ_by_at_most(other, at_middle, bound) ? 0u : 1u;
            counts.wrong_if_smaller += differ_by_at_most(other, at_middle, 0.3 * bound) ? 0u : 1u;
            counts.tight += differ_by_at_most(other, at_middle, 0.7 * bound) ? 0u : 1u;
        }
    }
}

Counts check_kind(Kind kind, std::uint64_t rounds) {
    Counts counts;
    for (SeededRandom random : seeds(rounds)) {
        const Keys keys = on_grid(make_keys(kind, random));
        const MeetingBodies bodies(keys, random);
        const OraclePath a(keys.from.a, keys.to.a);
        const OraclePath b(keys.from.b, keys.to.b);
        for (const Meeting& meeting : bodies.meetings) {
            check_meeting(bodies, a, b, meeting, counts);
        }
    }
    return counts;
}

// Each kind has 25 * 40 * 8 * 2 = 16,000 checks, all together 128,000.
TEST(MotionBound, NoPointsMoveFartherAgainstEachOther) {
    std::uint64_t checks = 0;
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        const Counts counts = check_kind(kind, raised(25));
        checks += counts.checks;
        EXPECT_EQ(counts.wrong, 0u);
        EXPECT_GT(counts.wrong_if_smaller, 0u);
    }
    EXPECT_GE(checks, 100'000u);
}

TEST(MotionBound, IsNotMuchLargerThanItMustBe) {
    for (const Kind kind : {Kind::Anything, Kind::Translation, Kind::Hinge}) {
        SCOPED_TRACE(static_cast<int>(kind));
        EXPECT_GT(check_kind(kind, 5).tight, 0u);
    }
}

double bound_of(const Keys& keys, const BodyRadii& radii, const TimeCell& cell) {
    const Keys rounded = on_grid(keys);
    const BodyPath a = path_between(rounded.from.a, rounded.to.a).value();
    const BodyPath b = path_between(rounded.from.b, rounded.to.b).value();
    return cell_bound(a, b, radii, cell, infinity);
}

TEST(MotionBound, OfATranslationIsHalfItsLength) {
    const Pose rest = turned_pose(30, Vec3(0, 0, 1));
    const Keys keys{{rest, moved_pose({0, 0, 0})}, {rest, moved_pose({3, 4, 0})}};
    const double bound = bound_of(keys, {1e6, 1e6}, {});
    EXPECT_GE(bound, 2.5);
    EXPECT_LE(bound, 2.5 * (1 + 0x1p-38));
    EXPECT_LE(bound_of(keys, {1e6, 1e6}, {4, 7}), 2.5 * (1 + 0x1p-38) / 16);
}

TEST(MotionBound, OfEqualKeysIsAlmostNothing) {
    const PosePair key{turned_pose(30, Vec3(0, 0, 1), Vec3(1e6, 2, 3)), moved_pose({4, 5, 6})};
    EXPECT_LE(bound_of({key, key}, {1, 1}, {}), 0x1p-500);
}

TEST(MotionBound, BodiesThatTurnTogetherHaveASmallOne) {
    const Vec3 axis(0, 0, 1);
    const double degrees = 10;
    const Vec3 arm(-8, 0, 0);
    const Vec3 move(20, 1, 0);
    const Vec3 carried = turned_pose(degrees, axis).apply(arm);
    const Keys keys{{moved_pose({0, 0, 0}), moved_pose(arm)},
                    {turned_pose(degrees, axis, move), turned_pose(degrees, axis, move + carried)}};
    const double turned = degrees * 3.14159265358979323846 / 180;
    // In the world each point of B alone moves by more than half of its arc.
    EXPECT_LT(bound_of(keys, {4, 4}, {5, 11}), 0.02 * turned * (8 + 4) / 64);
}

TEST(MotionBound, AtMostHalfOfTheCellAbove) {
    for (SeededRandom random : seeds(50)) {
        const Keys keys = on_grid(make_keys(Kind::Anything, random));
        const BodyPath a = path_between(keys.from.a, keys.to.a).value();
        const BodyPath b = path_between(keys.from.b, keys.to.b).value();
        double bound = cell_bound(a, b, {2, 3}, {}, infinity);
        for (unsigned level = 1; level < 10; ++level) {
            const auto index = static_cast<std::uint32_t>(random() >> (64 - level));
            const double next = cell_bound(a, b, {2, 3}, {level, index}, bound);
            EXPECT_LE(next, bound / 2);
            EXPECT_GT(next, 0);
            bound = next;
        }
    }
}

TEST(MovementBound, OfTwoBodiesTogetherIsAtLeastTheBoundOfTheirMotion) {
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        for (SeededRandom random : seeds(raised(100))) {
            const Keys keys = on_grid(make_keys(kind, random));
            const BodyPath a = path_between(keys.from.a, keys.to.a).value();
            const BodyPath b = path_between(keys.from.b, keys.to.b).value();
            const BodyRadii radii{uniform(random, 0, 2), uniform(random, 0, 2)};
            const double sum = movement_bound(a, radii.a) + movement_bound(b, radii.b);
            EXPECT_LE(cell_bound(a, b, radii, {}, infinity), (1 + 0x1p-40) * sum);
        }
    }
}

TEST(MovementBound, IsHalfAWayOrTheArcOfTheRadius) {
    const BodyPath moved = path_between(moved_pose({1, 2, 3}), moved_pose({4, 6, 3})).value();
    EXPECT_NEAR(movement_bound(moved, 100), 2.5, 1e-9);
    const Pose rest = moved_pose({0, 0, 0});
    const BodyPath turned = path_between(rest, turned_pose(2, Vec3(0, 0, 1))).value();
    const double arc = 3.14159265358979323846 / 180;
    EXPECT_GE(movement_bound(turned, 10), 10 * arc);
    EXPECT_LE(movement_bound(turned, 10), 10 * arc * 1.001);
    EXPECT_EQ(movement_bound(turned, infinity), infinity);
    EXPECT_EQ(movement_bound(path_between(rest, rest).value(), infinity), infinity);
}

TEST(BodyRadius, BoundsEveryVertex) {
    const std::vector<Vec3> points{{3, 4, 0}, {1, 1, 1}, {0, 0, 0}};
    EXPECT_GE(body_radius(points), 5);
    EXPECT_LE(body_radius(points), 5 * (1 + 0x1p-49));
    EXPECT_EQ(body_radius(std::vector<Vec3>{{0, 0, 0}}), 0);
    EXPECT_GE(body_radius(std::vector<Vec3>{{0x1p-700, 0, 0}}), 0x1p-700);
    EXPECT_EQ(body_radius(std::vector<Vec3>{{0x1p+600, 0, 0}}), infinity);
}

} // namespace

} // namespace cd::tests
