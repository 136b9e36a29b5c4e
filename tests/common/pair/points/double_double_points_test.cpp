// Proves that the error bounds of the fast path to shared points are needed and sufficient: on
// pairs whose points are as near the midpoint of two doubles as a translation can bring them, its
// answers are right, and become wrong if its bounds are scaled down.
#include "common/pair/points/double_double_points.hpp"

#include "common/pair/points/exact_points.hpp"
#include "tests/common/pair/points/middle_pairs.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace cd::tests {

namespace {

/// Returns the fast path's own answer, if it has one.
std::optional<PairPoints> fast_points(const PosedPair& c, double bound_scale, const Vec3& origin) {
    DoubleDoublePoints fast(c.poses, bound_scale);
    if (!fast.take(c.a, c.b, origin)) {
        return std::nullopt;
    }
    auto points = fast.ends();
    if (!points) {
        const auto corners = SharedCornerFinder(c.poses).find(c.a, c.b);
        points = corners
                     ? fast.at(*corners, [&] { return ExactPoints(c.poses).offset(c.a, origin); })
                     : std::nullopt;
    }
    return points ? std::optional(PairPoints{origin, {points->begin(), points->end()}})
                  : std::nullopt;
}

/// Makes touching pairs on a lattice, turned together.
PosedPair touching(std::mt19937_64& random, const Corners& a, const Corners& b) {
    PosedPair c{a, b, {}};
    c.poses.a = c.poses.b = moved({{}, {}, {make_pose(random, 1), Pose{}}}, Vec3::Zero()).poses.a;
    return c;
}

std::map<std::string, PairMaker> makers() {
    std::map<std::string, PairMaker> all;
    all["crossing"] = [](auto& r) {
        return moved(
            {random_corners(r, 1), random_corners(r, 1), {make_pose(r, 1), make_pose(r, 1)}},
            Vec3::Zero());
    };
    all["crossing, matrices"] = [](auto& r) {
        return moved({random_corners(r, 1),
                      random_corners(r, 1),
                      {make_matrix_pose(r, 1), make_matrix_pose(r, 1)}},
                     Vec3::Zero());
    };
    all["corner on face"] = [](auto& r) {
        Corners a = lattice_corners(r, 9);
        Corners b = lattice_corners(r, 9);
        for (Vec3& corner : a) {
            corner.z() = 2;
        }
        b[0].z() = 2;
        b[1].z() = 4;
        b[2].z() = 7;
        return touching(r, a, b);
    };
    all["in one plane"] = [](auto& r) {
        Corners a = lattice_corners(r, 9);
        Corners b = lattice_corners(r, 9);
        for (std::size_t i = 0; i < 3; ++i) {
            a[i].z() = b[i].z() = 2;
        }
        return touching(r, a, b);
    };
    return all;
}

/// Returns the number of wrong answers.
int wrong_answers(const PairMaker& make, double bound_scale, std::uint64_t rounds) {
    const auto answer = [&](const PosedPair& c, const Vec3& origin) {
        return fast_points(c, bound_scale, origin);
    };
    return wrong_answers_of(make, answer, rounds);
}

} // namespace

TEST(DoubleDoublePoints, AreRightNearTheMiddleBetweenTwoDoublesOrNotGiven) {
    for (const auto& [name, make] : makers()) {
        EXPECT_EQ(wrong_answers(make, 1, 24), 0) << name;
    }
}

TEST(DoubleDoublePoints, WouldBeWrongWithBoundsThatAreTooSmall) {
    for (const auto& [name, make] : makers()) {
        EXPECT_GT(wrong_answers(make, 0x1p-20, 48), 1) << name;
    }
}

TEST(DoubleDoublePoints, AnOriginWouldBeWrongWithBoundsThatAreTooSmall) {
    for (const double bound_scale : {1.0, 0x1p-20}) {
        int wrong = 0;
        for (SeededRandom random : seeds(200)) {
            const PosedPair base{random_corners(random, 1), {}, {make_pose(random, 1), Pose{}}};
            const PosedPair still = moved(base, Vec3::Zero());
            const RationalPoint at = clipping_oracle_world(still.poses.a, still.a[0]);
            Vec3 by;
            for (std::size_t k = 0; k < 3; ++k) {
                by[static_cast<Eigen::Index>(k)] =
                    Rational(middle_near(at[k]) - at[k]).convert_to<double>();
            }
            const PosedPair c = moved(base, by);
            const auto origin = DoubleDoublePoints(c.poses, bound_scale).origin(c.a);
            const RationalPoint exact = clipping_oracle_world(c.poses.a, c.a[0]);
            for (std::size_t k = 0; origin && k < 3; ++k) {
                const double value = (*origin)[static_cast<Eigen::Index>(k)];
                wrong += is_nearest_double(value, exact[k]) ? 0 : 1;
            }
        }
        if (bound_scale == 1) {
            EXPECT_EQ(wrong, 0);
        } else {
            EXPECT_GT(wrong, 5);
        }
    }
}

} // namespace cd::tests
