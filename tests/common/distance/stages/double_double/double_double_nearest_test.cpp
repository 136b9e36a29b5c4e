// Proves that the error bounds of nearest points in double-double are sufficient and needed: on
// pairs with a coordinate as near the midpoint of two doubles as a translation can bring it, its
// answers are right, and become wrong if its bounds are scaled down.
#include "common/distance/stages/double_double/double_double_nearest.hpp"

#include "common/distance/stages/double/double_distance.hpp"
#include "common/pair/points/exact_points.hpp"
#include "tests/support/brink_boxes.hpp"
#include "tests/support/distance_oracle.hpp"
#include "tests/support/distance_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

/// Returns the midpoint of two adjacent doubles that is nearest to a number.
mpq_class middle_of_doubles(const mpq_class& exact) {
    const double nearest = oracle_nearest(exact);
    const double infinity = std::numeric_limits<double>::infinity();
    const double next = std::nextafter(nearest, mpq_class(nearest) < exact ? infinity : -infinity);
    return (mpq_class(nearest) + mpq_class(next)) / 2;
}

/// Makes two triangles in turned bodies that share no point.
PosedPair turned_apart(std::mt19937_64& random, bool is_matrix) {
    PosedPair c{random_corners(random, 1), random_corners(random, 1), {}};
    const auto turn = [&] {
        const Pose pose = is_matrix ? make_matrix_pose(random, 1) : make_pose(random, 1);
        return with_translation(pose, Vec3::Zero());
    };
    c.poses = {turn(), turn()};
    for (Vec3& corner : c.b) {
        corner.x() += 4;
    }
    return c;
}

/// Moves both bodies, by far less than a coordinate's ulp, so that a coordinate of a nearest point
/// is near a midpoint.
PosedPair nearest_at_middle(std::mt19937_64& random, PosedPair c) {
    const DistanceOracle oracle(c.a, c.b, c.poses);
    const Vec3 origin = oracle.nearest().origin;
    const std::size_t k = random() % 3;
    const auto axis = static_cast<Eigen::Index>(k);
    const mpq_class value =
        oracle.exact_nearest().points[random() % 2][k] - mpq_class(origin[axis]);
    Vec3 by = Vec3::Zero();
    by[axis] = mpq_class(middle_of_doubles(value) - value).get_d();
    c.poses = {with_translation(c.poses.a, by), with_translation(c.poses.b, by)};
    return c;
}

std::optional<NearestPoints> in_double_double(const PosedPair& c, double error_scale) {
    const ExactPoints exact(c.poses);
    const Vec3 origin = exact.origin(c.a);
    return DoubleDoubleNearest(c.poses, error_scale)
        .nearest(c.a, c.b, origin, DoubleDistance(c.poses).choose(c.a, c.b).feature, [&] {
            return exact.offset(c.a, origin);
        });
}

bool is_same(const NearestPoints& l, const NearestPoints& r) {
    return l.feature == r.feature && l.origin == r.origin && l.of_a == r.of_a && l.of_b == r.of_b;
}

struct Answers {
    int given = 0;
    int wrong = 0;
};

Answers answers_near_the_middle(double error_scale) {
    Answers answers;
    for (SeededRandom random : seeds(200)) {
        const PosedPair c = nearest_at_middle(random, turned_apart(random, random.seed % 2 == 0));
        if (const auto found = in_double_double(c, error_scale)) {
            ++answers.given;
            answers.wrong += is_same(*found, DistanceOracle(c.a, c.b, c.poses).nearest()) ? 0 : 1;
        }
    }
    return answers;
}

} // namespace

TEST(DoubleDoubleNearest, IsRightNearTheMiddleBetweenTwoDoublesOrNotGiven) {
    EXPECT_EQ(answers_near_the_middle(1).wrong, 0);
}

TEST(DoubleDoubleNearest, WouldBeWrongWithBoundsThatAreTooSmall) {
    EXPECT_GT(answers_near_the_middle(0x1p-20).wrong, 1);
}

TEST(DoubleDoubleNearest, AnswersMostOrdinaryPairs) {
    int given = 0;
    for (SeededRandom random : seeds(100)) {
        given += in_double_double(turned_apart(random, true), 1) ? 1 : 0;
    }
    EXPECT_GT(given, 95);
}

TEST(DoubleDoubleNearest, AnswersPlatesWhoseFeaturesTie) {
    const PairMaker make = distance_pair_makers().at("parallel plates, whole gap");
    int given = 0;
    int apart = 0;
    for (SeededRandom random : seeds(100)) {
        const PosedPair c = make(random);
        const DistanceOracle oracle(c.a, c.b, c.poses);
        if (oracle.share_a_point()) {
            continue;
        }
        ++apart;
        if (const auto found = in_double_double(c, 1)) {
            ++given;
            EXPECT_TRUE(is_same(*found, oracle.nearest()));
        }
    }
    EXPECT_GT(given, apart / 10);
}

} // namespace cd::tests
