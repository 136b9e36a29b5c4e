// Proves that a polygon is cut into triangles of its own orientation whose areas add up to its
// area; for a simple outline they thus cover it exactly once. Other outlines are refused.
#include "client/import/polygon_cut.hpp"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace cd::tests {

namespace {

using testing::ElementsAre;

std::vector<Triangle> cut(const std::vector<Vec3>& corners) {
    PolygonCutter cutter;
    const auto triangles = cutter.cut(corners);
    return {triangles.begin(), triangles.end()};
}

/// Returns twice the area in the x-y plane; exact for small integer coordinates.
double area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a).z();
}

/// Returns distinct integer directions around the origin, counter-clockwise.
std::vector<Vec3> directions() {
    std::vector<Vec3> all;
    for (int x = -7; x <= 7; ++x) {
        for (int y = -7; y <= 7; ++y) {
            if (std::gcd(x, y) == 1) {
                all.emplace_back(x, y, 0);
            }
        }
    }
    std::sort(all.begin(), all.end(), [](const Vec3& left, const Vec3& right) {
        return std::atan2(left.y(), left.x()) < std::atan2(right.y(), right.x());
    });
    return all;
}

/// Makes a polygon fully visible from the origin: a random distance in each of some directions.
std::vector<Vec3> star(std::mt19937_64& random) {
    std::vector<Vec3> corners;
    for (const Vec3& direction : directions()) {
        const bool is_axis = direction.x() == 0 || direction.y() == 0; // Keeps the origin inside.
        if (is_axis || random() % 4 == 0) {
            corners.push_back(static_cast<double>(1 + random() % 20) * direction);
        }
    }
    const auto first = static_cast<std::ptrdiff_t>(random() % corners.size());
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
    return corners;
}

void expect_covered(const std::vector<Vec3>& corners) {
    const std::vector<Triangle> triangles = cut(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    double outline = 0;
    double covered = 0;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        outline += area(corners[0], corners[i], corners[i + 1]);
    }
    for (const Triangle& t : triangles) {
        const double of_triangle = area(corners[t[0]], corners[t[1]], corners[t[2]]);
        EXPECT_GE(of_triangle * outline, 0);
        covered += of_triangle;
    }
    EXPECT_EQ(covered, outline);
}

} // namespace

TEST(PolygonCut, StarsOfManyCornersAreCovered) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937_64 random(seed);
        std::vector<Vec3> corners = star(random);
        expect_covered(corners);
        std::reverse(corners.begin(), corners.end());
        expect_covered(corners);
    }
}

TEST(PolygonCut, PolygonsInAnyPlaneAreCut) {
    std::mt19937_64 random(1);
    const std::vector<Vec3> flat = star(random);
    const std::vector<Triangle> expected = cut(flat);
    ASSERT_FALSE(expected.empty());
    for (int turns = 1; turns < 3; ++turns) {
        std::vector<Vec3> turned;
        for (const Vec3& corner : flat) {
            turned.emplace_back(
                corner[(3 - turns) % 3], corner[(4 - turns) % 3], corner[(5 - turns) % 3]);
        }
        EXPECT_EQ(cut(turned), expected);
    }
}

TEST(PolygonCut, AConvexPolygonIsAFanAroundItsLastCorner) {
    const std::vector<Vec3> corners{{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {2, 4, 0}, {0, 4, 0}};
    EXPECT_THAT(cut(corners), ElementsAre(Triangle{4, 0, 1}, Triangle{4, 1, 2}, Triangle{2, 3, 4}));
}

TEST(PolygonCut, AQuadIsCutFromItsConcaveCorner) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_THAT(cut(square), ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
    const std::vector<Vec3> arrow{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
    EXPECT_THAT(cut(arrow), ElementsAre(Triangle{2, 3, 0}, Triangle{2, 0, 1}));
}

TEST(PolygonCut, CornersOnALineGiveTrianglesWithoutArea) {
    expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}});
    expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}});
    EXPECT_EQ(cut({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}}).size(), 3u);
    EXPECT_EQ(cut(std::vector<Vec3>(6, Vec3(1, 2, 3))).size(), 4u);
}

TEST(PolygonCut, AHoleThatABridgeJoinsIsLeftOpen) {
    expect_covered({{0, 0, 0},
                    {6, 0, 0},
                    {6, 6, 0},
                    {0, 6, 0},
                    {0, 0, 0},
                    {2, 2, 0},
                    {2, 4, 0},
                    {4, 4, 0},
                    {4, 2, 0},
                    {2, 2, 0}});
}

TEST(PolygonCut, OutlinesThatCrossThemselvesAreRefused) {
    EXPECT_TRUE(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(cut({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}, {-1, 2, 0}}).empty());
}

} // namespace cd::tests
