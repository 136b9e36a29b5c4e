// Proves that the box of a moving body contains it at every time, compared in integers; that it
// needs all of the movement's bound for that; and that results of motions whose boxes are apart
// tell nothing.

#include "common/scene/swept_box.hpp"

#include "common/core/limits/engine.hpp"
#include "common/motion/cells.hpp"
#include "common/motion/key_grid.hpp"
#include "tests/support/motion_oracle.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace cd::tests {

namespace {

constexpr unsigned instants_level = 24;
constexpr std::uint64_t instants = 1u << instants_level;

enum class Kind { Anything, AlongAnAxis, Hinge, HalfTurn, Slow, Far };
constexpr std::array kinds{
    Kind::Anything, Kind::AlongAnAxis, Kind::Hinge, Kind::HalfTurn, Kind::Slow, Kind::Far};

/// The vertices of a body, and its path.
struct Mover {
    std::vector<Vec3> points;
    Pose from;
    Pose to;

    [[nodiscard]] MovingBody body() const {
        MovingBody made{{}, body_radius(points), path_between(from, to).value()};
        for (const Vec3& point : points) {
            made.box.add(point);
        }
        return made;
    }
};

Mover make_mover(Kind kind, std::mt19937_64& random) {
    Mover made;
    for (int i = 0; i < 12; ++i) {
        made.points.push_back(random_point(random, 2));
    }
    const Pose start = make_pose(random, kind == Kind::Far ? 1e6 : 3);
    const Vec3 move = random_point(random, 2);
    Pose end = start;
    switch (kind) {
    case Kind::Anything:
    case Kind::Far:
        end = key_after(start, uniform(random, 0, 170), random_axis(random), move);
        break;
    case Kind::AlongAnAxis:
        end = key_after(start, 0, Vec3(1, 0, 0), Vec3(0, move.y(), 0));
        break;
    case Kind::Hinge:
        // A rod, which lies along the x axis in the middle of its turn.
        made.points = {Vec3(0, 0, 0), Vec3(uniform(random, 1, 2), 0, 0)};
        end = turned_pose(uniform(random, 1, 40), Vec3(0, 0, 1));
        made.from =
            Pose::from_quaternion({end.quaternion().w, 0, 0, -end.quaternion().z}, Vec3::Zero());
        made.to = end;
        break;
    case Kind::HalfTurn:
        end = key_after(start, 179, random_axis(random), move);
        break;
    case Kind::Slow:
        end = key_after(start, 1e-7, random_axis(random), 1e-9 * move);
        break;
    }
    if (kind != Kind::Hinge) {
        made.from = start;
        made.to = end;
    }
    const KeyGrid grid{12, 21};
    made.from = grid.rounded(made.from);
    made.to = grid.rounded(made.to);
    return made;
}

/// Whether the box contains a place that is moved by `margin` along an axis.
bool contains(const WorldBox& box,
              const OraclePath::Place& place,
              std::size_t axis,
              double margin) {
    const auto scaled = [&](double number) -> Integer {
        return Integer(std::ldexp(number, 128)) * place.denominator;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Integer at = place.point[i] + (i == axis ? scaled(margin) : Integer(0));
        if (at < scaled(box.low[i]) || at > scaled(box.high[i])) {
            return false;
        }
    }
    return true;
}

struct Counts {
    std::uint64_t checks = 0;
    std::uint64_t misses = 0;
    std::uint64_t misses_if_smaller = 0; ///< Of boxes with 0.9 of the bound.
};

void check_mover(const Mover& mover, std::mt19937_64& random, Counts& counts) {
    const MovingBody body = mover.body();
    const OraclePath path(mover.from, mover.to);
    const double margin = random() % 2 == 0 ? 0 : 0.25;
    const WorldBox box = swept_box(body, margin);
    const double movement = movement_bound(body.path, body.radius);
    const WorldBox smaller = world_box(body.box, pose_at(body.path, 0.5), 0.9 * movement + margin);
    for (const Vec3& point : mover.points) {
        for (const std::uint64_t instant :
             {std::uint64_t{0}, instants, random() % instants, random() % instants}) {
            const OraclePath::Place place = path.place(point, instant, instants_level);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (const double off : {-margin, margin}) {
                    ++counts.checks;
                    counts.misses += contains(box, place, axis, off) ? 0u : 1u;
                    counts.misses_if_smaller += contains(smaller, place, axis, off) ? 0u : 1u;
                }
            }
        }
    }
}

} // namespace

// Five kinds have 75 * 12 * 4 * 6 = 21,600 checks each, all together more than 100,000.
TEST(SweptBox, ContainsTheBodyAtEveryTime) {
    std::uint64_t checks = 0;
    for (const Kind kind : kinds) {
        SCOPED_TRACE(static_cast<int>(kind));
        Counts counts;
        for (SeededRandom random : seeds(raised(75))) {
            check_mover(make_mover(kind, random), random, counts);
        }
        checks += counts.checks;
        EXPECT_EQ(counts.misses, 0u);
        if (kind == Kind::AlongAnAxis || kind == Kind::Hinge) {
            EXPECT_GT(counts.misses_if_smaller, 0u);
        }
    }
    EXPECT_GE(checks, 100'000u);
}

TEST(SweptBox, OfABodyAtRestIsItsBox) {
    for (SeededRandom random : seeds(30)) {
        Mover mover = make_mover(Kind::Anything, random);
        mover.to = mover.from;
        const MovingBody body = mover.body();
        const WorldBox box = swept_box(body, 0.5);
        const WorldBox at_rest = world_box(body.box, mover.from, 0.5);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(box.low[i], at_rest.low[i]);
            EXPECT_GE(box.low[i], std::nextafter(at_rest.low[i], -10.0f));
            EXPECT_GE(box.high[i], at_rest.high[i]);
            EXPECT_LE(box.high[i], std::nextafter(at_rest.high[i], 10.0f));
        }
    }
}

TEST(SweptBox, IsInfiniteWhereTheRadiusIs) {
    Mover mover{{Vec3(1e300, 0, 0)}, turned_pose(0, Vec3(1, 0, 0)), turned_pose(9, Vec3(1, 0, 0))};
    const WorldBox box = swept_box(mover.body(), 0);
    EXPECT_EQ(box.low[1], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(box.high[2], std::numeric_limits<float>::infinity());
}

// Two points slide along each other. If they are farther apart than the reach and its part of M,
// boxes may exclude the motion, so its result has to say that they are free. With a smaller gap the
// search ends early, though no part of the time stays open.
TEST(ReachOfMotions, BeyondItASearchFindsTheBodiesFree) {
    const double resolution = 0x1p-18;
    const auto end_at = [&](double gap) {
        const PosePair from{moved_pose({-0.5, 0, 0}), moved_pose({0.5, gap, 0})};
        const PosePair to{moved_pose({0.5, 0, 0}), moved_pose({-0.5, gap, 0})};
        const Motion motion = make_motion(from, to, {0, 0}, resolution);
        // As if the bodies met each other all along.
        const CellQuestions sliding{[&](const PosePair&, double within) { return gap <= within; },
                                    [](const PosePair&) { return false; }};
        EXPECT_EQ(motion.depth(), 19u);
        return search_cells(motion, Until::Contact, 0.25, sliding).end;
    };
    const double reach = reach_of_motions(0.25, resolution);
    const double part = 2.0 / limits::motion_cells_max; // M of the whole is 1, slightly more.
    EXPECT_EQ(end_at(reach + part), MotionEnd::Free);
    EXPECT_EQ(end_at(reach + 0.9 * part - resolution), MotionEnd::Limit);
}

} // namespace cd::tests
