// Proves that chosen points span all points within eps, by separating planes in long double.
#include "common/tree/planes/hull_choice.hpp"

#include "common/tree/planes/hull_distance.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace cd::tests {

namespace {

using Long3 = Eigen::Matrix<long double, 3, 1>;
using LongX = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

Long3 long_of(const FloatPoint& point) {
    return {point[0], point[1], point[2]};
}

/// Sets a combination of vectors that is nearest to the origin, and keeps only those it needs:
/// tries all subsets.
Long3 nearest_combination(std::vector<Long3>& vectors) {
    Long3 nearest = vectors.front();
    std::vector<Long3> needed{nearest};
    for (unsigned subset = 1; subset < 1u << vectors.size(); ++subset) {
        std::vector<Long3> some;
        for (std::size_t i = 0; i < vectors.size(); ++i) {
            if ((subset >> i & 1u) != 0) {
                some.push_back(vectors[i]);
            }
        }
        const auto n = static_cast<Eigen::Index>(some.size());
        // Solves for weights of sum 1 whose combination of the points is perpendicular to each
        // difference of two points: the nearest place to the origin on their affine hull.
        Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> rows(n, n);
        LongX right = LongX::Zero(n);
        right[0] = 1;
        rows.row(0).setOnes();
        for (Eigen::Index i = 1; i < n; ++i) {
            const Long3 along = some[static_cast<std::size_t>(i)] - some[0];
            for (Eigen::Index k = 0; k < n; ++k) {
                rows(i, k) = along.dot(some[static_cast<std::size_t>(k)]) /
                             std::max(along.squaredNorm(), 1e-4000L);
            }
        }
        const LongX weights = rows.fullPivLu().solve(right);
        if (!(weights.minCoeff() >= 0) || std::abs(weights.sum() - 1) > 1e-9L) {
            continue;
        }
        Long3 sum = Long3::Zero();
        for (Eigen::Index i = 0; i < n; ++i) {
            sum += weights[i] * some[static_cast<std::size_t>(i)];
        }
        if (sum.norm() < nearest.norm()) {
            nearest = sum;
            needed = some;
        }
    }
    vectors = needed;
    return nearest;
}

/// Returns how far a plane separates a point from others: at most its distance from their hull,
/// nearly that unless the distance is below `enough`.
long double separation(const Long3& point, const std::vector<Long3>& others, long double enough) {
    std::vector<Long3> vectors{others.front() - point};
    long double most = 0;
    for (int step = 0; step < 100; ++step) {
        const Long3 nearest = nearest_combination(vectors);
        const long double distance = nearest.norm();
        if (distance <= enough) {
            break;
        }
        const Long3 normal = nearest / distance;
        const auto next = std::ranges::min_element(
            others, {}, [&](const Long3& other) { return normal.dot(other); });
        const long double gap = normal.dot(*next - point);
        most = std::max(most, gap);
        if (gap >= distance * (1 - 1e-9L) ||
            std::ranges::find(vectors, *next - point) != vectors.end() || vectors.size() == 4) {
            break;
        }
        vectors.emplace_back(*next - point);
    }
    return most;
}

enum class Cloud { Ball, Sphere, Panel, Lattice, Plane, Sliver, Noise, Needle, Line, Ends, Point };
constexpr std::size_t cloud_kinds = 11;

Vec3 any_point(std::mt19937_64& random, Cloud kind) {
    const Vec3 point = random_point(random, 1);
    const auto whole = [&] { return static_cast<double>(random() % 7) / 3 - 1; };
    switch (kind) {
    case Cloud::Ball:
        return point;
    case Cloud::Sphere:
        return point.normalized();
    case Cloud::Panel:
        return {point.x(), point.y(), 0.1 * point.x() * point.x() + 0.02 * std::sin(3 * point.y())};
    case Cloud::Lattice: // Of a cube, with many points in a plane or line, many of them equal.
        return {whole(), whole(), whole()};
    case Cloud::Plane:
        return {point.x(), point.y(), 0.25 * point.x() + 0.5 * point.y()};
    case Cloud::Sliver:
        return {point.x(), 0x1p-12 * point.y(), 0x1p-20 * point.z()};
    case Cloud::Noise: // As thin as what rounding does to planes.
        return {whole(), whole(), 0x1p-44 * whole()};
    case Cloud::Needle: { // So thin that corners see facets that make no patch.
        const double x = whole();
        return {x, 0.5 * x + 0x1p-28 * whole(), 0.25 * x + 0x1p-34 * whole()};
    }
    case Cloud::Line:
        return point.x() * Vec3(1, 0.5, 0.25);
    case Cloud::Ends:
        return random() % 2 == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    default:
        return {0.25, 0.5, 0.75};
    }
}

/// Points with a bound on their distance from the origin.
struct Points {
    std::vector<FloatPoint> all;
    double radius = 0;
};

Points any_points(std::mt19937_64& random,
                  Cloud kind,
                  std::size_t count,
                  double scale = 1,
                  const Vec3& offset = Vec3::Zero()) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 point = scale * (any_point(random, kind) + offset);
        const FloatPoint rounded{static_cast<float>(point.x()),
                                 static_cast<float>(point.y()),
                                 static_cast<float>(point.z())};
        points.all.push_back(rounded);
        points.radius = std::max(points.radius, (1 + 0x1p-40) * vector_of(rounded).norm());
    }
    return points;
}

/// Returns the largest separation of a point from the chosen ones. Expects it to be within eps.
long double expect_spanned(const Points& points, const HullChoice& choice) {
    std::vector<Long3> chosen;
    for (const std::uint32_t number : choice.numbers) {
        chosen.push_back(long_of(points.all[number]));
    }
    long double most = 0;
    for (const FloatPoint& point : points.all) {
        most = std::max(most, separation(long_of(point), chosen, 0.9L * choice.eps));
    }
    EXPECT_LE(most, choice.eps + 0x1p-60L * points.radius);
    return most;
}

TEST(HullChoice, BoundsHowFarPointsAreFromTheHullOfTheChosenOnes) {
    for (SeededRandom random : seeds(120)) {
        const auto kind = static_cast<Cloud>(random.seed % cloud_kinds);
        const std::array<double, 4> scales{1, 0x1p-140, 0x1p-60, 0x1p49};
        const double scale = scales[random() % 4];
        const Vec3 offset = random() % 3 == 0 ? Vec3(50, -100, 20) : Vec3(0, 0, 0);
        const Points points = any_points(random, kind, 1 + random() % 250, scale, offset);
        const std::size_t most = 4 + random() % 60;
        const double wanted = random() % 2 == 0 ? 0 : 0.01 * scale;
        const HullChoice choice = choose_hull(points.all, most, wanted, points.radius);
        EXPECT_LE(choice.numbers.size(), most);
        const std::set<std::uint32_t> unique(choice.numbers.begin(), choice.numbers.end());
        EXPECT_EQ(unique.size(), choice.numbers.size());
        if (choice.numbers.size() < most) {
            EXPECT_LE(choice.eps, std::max(wanted, 0x1p-44 * points.radius));
        }
        expect_spanned(points, choice);
    }
}

TEST(HullChoice, TellsNoMoreThanTheDistanceOfTheFarthestPoint) {
    for (SeededRandom random : seeds(10)) {
        for (const Cloud kind : {Cloud::Ball, Cloud::Sphere, Cloud::Panel}) {
            const Points points = any_points(random, kind, 200);
            const HullChoice choice = choose_hull(points.all, 16, 0, points.radius);
            EXPECT_GT(choice.eps, 0.001);
            EXPECT_GE(expect_spanned(points, choice), 0.98L * choice.eps);
        }
    }
}

TEST(HullChoice, NeedsFewPointsOfFlatsAndCubes) {
    std::mt19937_64 random(2);
    const auto chosen = [&](Cloud kind) {
        const Points points = any_points(random, kind, 3000);
        const HullChoice choice = choose_hull(points.all, 80, 0, points.radius);
        EXPECT_LE(choice.eps, 0x1p-44 * points.radius);
        return choice.numbers.size();
    };
    EXPECT_EQ(chosen(Cloud::Point), 1u);
    EXPECT_EQ(chosen(Cloud::Ends), 2u);
    EXPECT_LE(chosen(Cloud::Lattice), 8u + 4); // The first four may be no corners.
}

/// Returns the eps of the slow way: each time all distances from the hull decide who is next.
double eps_of_farthest_first(const Points& points, std::size_t count) {
    HullDistance hull(points.radius);
    FloatPoint next = points.all.front();
    double eps = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        hull.add(next);
        eps = 0;
        for (const FloatPoint& point : points.all) {
            const double bound = hull.bound(point, 0);
            next = bound > eps ? point : next;
            eps = std::max(eps, bound);
        }
    }
    return eps;
}

TEST(HullChoice, IsAboutAsGoodAsTakingTheFarthestPointEachTime) {
    for (SeededRandom random : seeds(4)) {
        for (const Cloud kind :
             {Cloud::Ball, Cloud::Sphere, Cloud::Panel, Cloud::Plane, Cloud::Sliver}) {
            SCOPED_TRACE(static_cast<int>(kind));
            const Points points = any_points(random, kind, 300);
            const double wanted = 0x1p-12 * points.radius;
            const double eps = choose_hull(points.all, 24, wanted, points.radius).eps;
            EXPECT_LE(eps, std::max(wanted, 2 * eps_of_farthest_first(points, 24)));
        }
    }
}

TEST(HullChoice, ManyPointsOfASphereLeaveLittleOut) {
    std::mt19937_64 random(1);
    const Points points = any_points(random, Cloud::Sphere, 4000);
    const double of_32 = choose_hull(points.all, 32, 0, points.radius).eps;
    const double of_128 = choose_hull(points.all, 128, 0, points.radius).eps;
    EXPECT_LT(of_32, 0.25);
    EXPECT_LT(of_128, 0.06);
    EXPECT_GT(of_128, 0.01);
}

} // namespace

} // namespace cd::tests
