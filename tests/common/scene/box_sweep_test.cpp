// Proves that the sweep finds the pairs of boxes that overlap and no others, against all pairs.

#include "common/scene/box_sweep.hpp"

#include "tests/common/scene/box_pairs.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

namespace cd::tests {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

using BoxMaker = std::function<WorldBox(std::mt19937_64&)>;

WorldBox box_around(const Vec3& middle, const Vec3& half) {
    WorldBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        box.low[i] = static_cast<float>(middle[axis] - std::abs(half[axis]));
        box.high[i] = static_cast<float>(middle[axis] + std::abs(half[axis]));
    }
    return box;
}

std::map<std::string, BoxMaker> box_makers() {
    return {
        {"town",
         [](std::mt19937_64& random) {
             const Vec3 place(uniform(random, -50, 50), uniform(random, -30, 30), 0);
             return box_around(place, Vec3(2, 1, 1));
         }},
        {"on a lattice, so that faces meet",
         [](std::mt19937_64& random) {
             const Vec3 place = random_point(random, 4).array().round();
             return box_around(place, Vec3::Constant(0.5));
         }},
        {"points of a lattice, with both zeros",
         [](std::mt19937_64& random) {
             const Vec3 place = random_point(random, 1.4).array().round();
             return box_around(random() % 2 == 0 ? place : Vec3(-place), Vec3::Zero());
         }},
        {"of many sizes",
         [](std::mt19937_64& random) {
             const double size = std::exp2(uniform(random, -10, 3));
             return box_around(random_point(random, 8), random_point(random, size));
         }},
        {"flat, on one plane or two",
         [](std::mt19937_64& random) {
             const Vec3 place(uniform(random, -9, 9), uniform(random, -9, 9), random() % 2);
             return box_around(place, Vec3(1, 1, 0));
         }},
        {"far from the origin, and as large as the steps of floats there",
         [](std::mt19937_64& random) {
             const Vec3 place(uniform(random, 3e6, 3e6 + 4), uniform(random, -5e6, -5e6 + 4), 100);
             return box_around(place, random_point(random, 0.5));
         }},
        {"nested",
         [](std::mt19937_64& random) {
             return box_around(Vec3::Constant(7),
                               Vec3::Constant(std::exp2(uniform(random, -20, 20))));
         }},
        {"all equal", [](std::mt19937_64&) { return box_around(Vec3(1, 2, 3), Vec3(4, 5, 6)); }},
        {"touching by a step of floats, or not",
         [](std::mt19937_64& random) {
             WorldBox box =
                 box_around(random_point(random, 2).array().round(), Vec3::Constant(0.5));
             float& end = random() % 2 == 0 ? box.low.at(random() % 3) : box.high.at(random() % 3);
             end = std::nextafter(end, random() % 2 == 0 ? -infinity : infinity);
             return box;
         }},
        {"all in one place",
         [](std::mt19937_64& random) { return box_around(Vec3::Zero(), random_point(random, 1)); }},
        {"some infinite", [](std::mt19937_64& random) {
             WorldBox box = box_around(random_point(random, 5), Vec3::Constant(0.5));
             if (random() % 4 == 0) {
                 box.low.at(random() % 3) = -infinity;
             }
             if (random() % 4 == 0) {
                 box.high.at(random() % 3) = infinity;
             }
             return box;
         }}};
}

} // namespace

TEST(BoxSweep, FindsThePairsThatOverlapAndNoOthers) {
    std::size_t pairs = 0;
    on_every_target([&](SimdTarget) {
        for (const auto& [name, make] : box_makers()) {
            SCOPED_TRACE(name);
            for (SeededRandom random : seeds(raised(40))) {
                std::vector<WorldBox> boxes(random() % 90);
                for (WorldBox& box : boxes) {
                    box = make(random);
                }
                const std::vector<BodyPair> truth = all_overlaps(boxes);
                EXPECT_EQ(overlapping_pairs(boxes), truth);
                pairs += truth.size();
            }
        }
    });
    EXPECT_GT(pairs, 10000u);
}

TEST(BoxSweep, LeavesOutThePairsOfTwoFixedBoxesAndNoOthers) {
    std::size_t pairs = 0;
    on_every_target([&](SimdTarget) {
        for (const auto& [name, make] : box_makers()) {
            SCOPED_TRACE(name);
            for (SeededRandom random : seeds(raised(20))) {
                std::vector<WorldBox> boxes(random() % 90);
                std::vector<std::uint8_t> is_fixed;
                const std::uint64_t movers = 1 + random() % 9; // One box of so many moves.
                for (WorldBox& box : boxes) {
                    box = make(random);
                    is_fixed.push_back(random() % movers == 0 ? 0 : 1);
                }
                std::vector<BodyPair> truth = all_overlaps(boxes);
                std::erase_if(truth, [&](BodyPair pair) {
                    return is_fixed[pair.a] != 0 && is_fixed[pair.b] != 0;
                });
                EXPECT_EQ(overlapping_pairs(boxes, is_fixed), truth);
                pairs += truth.size();
            }
        }
    });
    EXPECT_GT(pairs, 10000u);
}

TEST(BoxSweep, DividesManyBoxesIntoStripsAndLosesNone) {
    // On each axis a box overlaps a fifth of the others, but for those that reach through all.
    std::vector<std::vector<WorldBox>> crowds;
    for (SeededRandom random : seeds(raised(2))) {
        std::vector<WorldBox>& boxes = crowds.emplace_back();
        for (int i = 0; i < 3000; ++i) {
            boxes.push_back(box_around(random_point(random, 5), random_point(random, 1.1)));
            boxes.back().high.at(random() % 3) += random() % 100 == 0 ? infinity : 0;
        }
    }
    for (const std::vector<WorldBox>& boxes : crowds) {
        const std::vector<BodyPair> truth = all_overlaps(boxes);
        EXPECT_GT(truth.size(), 10000u);
        on_every_target([&](SimdTarget) { EXPECT_EQ(overlapping_pairs(boxes), truth); });
    }
}

TEST(BoxSweep, TakesTheAxisOnWhichFewBoxesOverlap) {
    // A column of 4,000 boxes along z takes a moment; all pairs of them would be 8 million.
    std::vector<WorldBox> boxes;
    for (int i = 0; i < 4000; ++i) {
        boxes.push_back(box_around(Vec3(0, 0, i), Vec3(100, 100, 0.5)));
    }
    const std::vector<BodyPair> pairs = overlapping_pairs(boxes);
    ASSERT_EQ(pairs.size(), 3999u);
    EXPECT_EQ(pairs.front(), (BodyPair{0, 1}));
    EXPECT_EQ(pairs.back(), (BodyPair{3998, 3999}));
}

TEST(BoxSweep, OfFewBoxesIsEmpty) {
    EXPECT_TRUE(overlapping_pairs({}).empty());
    const WorldBox box = box_around(Vec3::Zero(), Vec3::Constant(1));
    EXPECT_TRUE(overlapping_pairs({&box, 1}).empty());
}

} // namespace cd::tests
