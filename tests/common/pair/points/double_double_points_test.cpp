// Proves that the error bounds of the fast path to shared points are needed and sufficient: on
// pairs whose points are as near the midpoint of two doubles as a translation can bring them, its
// answers are right, and become wrong if its bounds are scaled down.
#include "common/pair/points/double_double_points.hpp"

#include "common/pair/points/exact_points.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/clipping_oracle.hpp"
#include "tests/support/hard_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

/// Returns the fast path's own answer, if it has one.
std::optional<std::vector<Vec3>>
fast_points(const PosedPair& c, double bound_scale, const Vec3& origin) {
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
    return points ? std::optional(std::vector<Vec3>(points->begin(), points->end())) : std::nullopt;
}

/// Returns the midpoint of two adjacent doubles that is nearest to a number.
Rational middle_near(const Rational& exact) {
    const auto nearest = exact.convert_to<double>();
    const double towards = Rational(nearest) < exact ? std::numeric_limits<double>::infinity()
                                                     : -std::numeric_limits<double>::infinity();
    return (Rational(nearest) + Rational(std::nextafter(nearest, towards))) / 2;
}

PosedPair moved(PosedPair c, const Vec3& by) {
    c.poses = {with_translation(c.poses.a, by), with_translation(c.poses.b, by)};
    return c;
}

/// Translates the pair, by far less than a coordinate's ulp, so that a component of one of its
/// points, relative to the origin, is near a midpoint.
PosedPair brought_to_middle(const PosedPair& c, const Vec3& origin, std::mt19937_64& random) {
    const std::vector<RationalPoint> points = clipping_oracle_points(c.a, c.b, c.poses);
    if (points.empty()) {
        return c;
    }
    const RationalPoint& point = points[random() % points.size()];
    const std::size_t k = random() % 3;
    const auto axis = static_cast<Eigen::Index>(k);
    const Rational value = point[k] - Rational(origin[axis]);
    Vec3 by = Vec3::Zero();
    by[axis] = Rational(middle_near(value) - value).convert_to<double>();
    return moved(c, by);
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
    int wrong = 0;
    for (SeededRandom random : seeds(rounds)) {
        const PosedPair base = make(random);
        const std::optional<Vec3> origin = DoubleDoublePoints(base.poses).origin(base.a);
        if (!origin) {
            continue;
        }
        const PosedPair c = brought_to_middle(base, *origin, random);
        const auto points = fast_points(c, bound_scale, *origin);
        if (!points || points->empty()) {
            continue;
        }
        const std::vector<RationalPoint> expected = clipping_oracle_points(c.a, c.b, c.poses);
        bool is_right = points->size() == expected.size();
        for (std::size_t i = 0; is_right && i < expected.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto axis = static_cast<Eigen::Index>(k);
                is_right =
                    is_right && is_nearest_double((*points)[i][axis],
                                                  expected[i][k] - Rational((*origin)[axis]));
            }
        }
        wrong += is_right ? 0 : 1;
    }
    return wrong;
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
