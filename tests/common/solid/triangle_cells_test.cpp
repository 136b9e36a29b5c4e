// Proves that a triangle is cut into as many cells as needed and no more: a centre in each face
// between the lines, none on a cut, and no split by a line that does not enter.

#include "common/solid/triangle_cells.hpp"

#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace cd::tests {

namespace {

const std::array<PlanePoint, 3> triangle{PlanePoint{0, 0}, {60, 0}, {0, 60}};

std::vector<PlanePoint> centres(const std::vector<PlaneCut>& cuts) {
    std::vector<PlanePoint> found;
    EXPECT_FALSE(any_cell_centre(triangle, cuts, [&](const PlanePoint& centre) {
        found.push_back(centre);
        return false;
    }));
    return found;
}

int side_of(const PlaneCut& line, const PlanePoint& p) {
    const Rational side = (line.to[0] - line.from[0]) * (p[1] - line.from[1]) -
                          (line.to[1] - line.from[1]) * (p[0] - line.from[0]);
    return side.sign();
}

std::vector<int> sides_of(const std::vector<PlaneCut>& lines, const PlanePoint& p) {
    std::vector<int> sides;
    for (const PlaneCut& line : lines) {
        sides.push_back(side_of(line, p));
    }
    return sides;
}

} // namespace

TEST(TriangleCells, WithoutCutsTheOnlyCentreIsTheCentroid) {
    EXPECT_EQ(centres({}), (std::vector<PlanePoint>{{20, 20}}));
    // Along an edge, from outside to a corner, beside, and a point on an edge.
    EXPECT_EQ(centres({{{0, 0}, {60, 0}},
                       {{-5, 5}, {5, -5}},
                       {{61, 0}, {0, 61}},
                       {{30, 30}, {30, 30}},
                       {{70, 1}, {80, 1}}})
                  .size(),
              1u);
}

TEST(TriangleCells, SegmentsAndPointsWithinSplit) {
    EXPECT_EQ(centres({{{10, 10}, {20, 10}}}).size(), 2u);
    EXPECT_EQ(centres({{{20, 20}, {20, 20}}}).size(), 2u);
    // The second segment is on the line of the first, which has already split the cell.
    EXPECT_EQ(centres({{{10, 10}, {20, 10}}, {{30, 10}, {40, 10}}, {{11, 10}, {11, 10}}}).size(),
              2u);
    // The third segment enters only the upper of the two cells.
    EXPECT_EQ(centres({{{10, 10}, {20, 10}}, {{10, 20}, {12, 22}}}).size(), 3u);
}

TEST(TriangleCells, EachFaceOfRandomLinesHasACentre) {
    for (SeededRandom random : seeds(60)) {
        const auto coordinate = [&] { return Rational(static_cast<int>(random() % 121) - 30); };
        std::vector<PlaneCut> lines;
        for (int i = 0; i < 6; ++i) {
            PlaneCut line{{-200, coordinate()}, {200, coordinate()}};
            if (i % 2 == 0) {
                std::swap(line.from[0], line.from[1]);
                std::swap(line.to[0], line.to[1]);
            }
            lines.push_back(line);
        }
        std::set<std::vector<int>> found;
        for (const PlanePoint& centre : centres(lines)) {
            const std::vector<int> sides = sides_of(lines, centre);
            EXPECT_EQ(std::count(sides.begin(), sides.end(), 0), 0);
            EXPECT_TRUE(found.insert(sides).second) << "one face, two cells";
        }
        for (int i = 0; i < 200; ++i) {
            const PlanePoint p{Rational(static_cast<int>(1 + random() % 600), 10),
                               Rational(static_cast<int>(1 + random() % 600), 10)};
            const std::vector<int> sides = sides_of(lines, p);
            if (p[0] + p[1] < 60 && std::count(sides.begin(), sides.end(), 0) == 0) {
                EXPECT_TRUE(found.contains(sides));
            }
        }
    }
}

TEST(TriangleCells, StopsWhenThePredicateIsTrue) {
    int asked = 0;
    EXPECT_TRUE(any_cell_centre(triangle,
                                std::vector<PlaneCut>{{{10, 10}, {20, 10}}},
                                [&](const PlanePoint&) { return ++asked == 1; }));
    EXPECT_EQ(asked, 1);
}

TEST(TriangleCells, PiecesOfASegmentHaveTheirMiddles) {
    std::vector<Rational> found;
    EXPECT_FALSE(any_piece_centre({Rational(1, 2), Rational(1, 4), Rational(1, 2)},
                                  [&](const Rational& middle) {
                                      found.push_back(middle);
                                      return false;
                                  }));
    EXPECT_EQ(found, (std::vector<Rational>{Rational(1, 8), Rational(3, 8), Rational(3, 4)}));
    EXPECT_TRUE(
        any_piece_centre({}, [](const Rational& middle) { return middle == Rational(1, 2); }));
}

} // namespace cd::tests
