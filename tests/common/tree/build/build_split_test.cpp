// Proves that a split has the least sum of relative segments that the rule admits: the sweep
// against all splits, the sweep of few triangles against the sweep, and bins against the sweep if
// they separate the triangles.

#include "common/tree/build/build_split.hpp"

#include "common/tree/build/build_few.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace cd::tests {

namespace {

double fraction(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Makes intervals of random length in a box of 1 x 2 x 3.
std::vector<Projection> random_projections(std::mt19937_64& random, std::size_t count) {
    std::vector<Projection> all(count);
    for (Projection& one : all) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double low = static_cast<double>(k + 1) * fraction(random);
            one[k] = {low, low + 0.3 * fraction(random)};
        }
    }
    return all;
}

Projection whole_of(std::span<const Projection> all) {
    Projection whole = empty_projection();
    for (const Projection& one : all) {
        extend(whole, one);
    }
    return whole;
}

/// Returns the sum of relative segments on an axis if these triangles go left.
double
segment_sum(std::span<const Projection> all, std::size_t axis, const std::vector<bool>& goes_left) {
    Projection left = empty_projection();
    Projection right = empty_projection();
    for (std::size_t i = 0; i < all.size(); ++i) {
        extend(goes_left[i] ? left : right, all[i]);
    }
    const Projection whole = whole_of(all);
    return (left[axis].high - left[axis].low + right[axis].high - right[axis].low) /
           (whole[axis].high - whole[axis].low);
}

std::vector<std::size_t> order_along(std::span<const Projection> all, std::size_t axis) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all[i][axis].high; });
    return order;
}

/// Returns the least sum of all splits on all axes with at least `side` triangles on each side.
double least_sum(std::span<const Projection> all, std::size_t side) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto order = order_along(all, axis);
        std::vector<bool> goes_left(all.size(), false);
        for (std::size_t i = 0; i + side < all.size(); ++i) {
            goes_left[order[i]] = true;
            if (i + 1 >= side) {
                least = std::min(least, segment_sum(all, axis, goes_left));
            }
        }
    }
    return least;
}

/// Returns each triangle's side after `part_triangles`.
std::vector<bool> sides_of(std::span<const Projection> all, const Split& split) {
    std::vector<BuildTriangle> triangles(all.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        triangles[i].id = i;
    }
    std::vector<BuildTriangle> scratch(all.size());
    const std::uint32_t left = part_triangles(triangles, all, 0, split, scratch);
    EXPECT_EQ(left, split.left_count);
    const auto by_id = [](const BuildTriangle& l, const BuildTriangle& r) { return l.id < r.id; };
    EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.begin() + left, by_id));
    EXPECT_TRUE(std::is_sorted(triangles.begin() + left, triangles.end(), by_id));
    std::vector<bool> goes_left(all.size(), false);
    for (std::uint32_t i = 0; i < left; ++i) {
        goes_left[triangles[i].id] = true;
    }
    return goes_left;
}

std::optional<Split> bin_split(std::span<const Projection> all) {
    const Projection whole = whole_of(all);
    Bins bins(whole);
    bins.add(all);
    SweepScratch scratch;
    return binned_split(all, whole, bins, scratch);
}

/// Makes triangles whose maxima are in the middles of different bins on each axis, in three orders.
std::vector<Projection> one_in_each_bin(std::mt19937_64& random) {
    constexpr std::size_t count = BinScale::bin_count;
    std::vector<Projection> all(count);
    for (std::size_t k = 0; k < 3; ++k) {
        std::vector<std::size_t> bins(count);
        std::iota(bins.begin(), bins.end(), std::size_t{0});
        std::shuffle(bins.begin(), bins.end(), random);
        for (std::size_t i = 0; i < count; ++i) {
            const double high = bins[i] + 1 == count ? count : static_cast<double>(bins[i]) + 0.5;
            all[i][k] = {bins[i] == 0 ? 0.0 : fraction(random) * high, high};
        }
    }
    return all;
}

TEST(BuildSplit, TheSweepFindsTheLeastSumOfAllSplits) {
    std::mt19937_64 random(1);
    SweepScratch scratch;
    for (const std::size_t count : {2u, 3u, 4u, 5u, 9u, 33u, 100u}) {
        for (int round = 0; round < 20; ++round) {
            SCOPED_TRACE(testing::Message() << count << ' ' << round);
            const auto all = random_projections(random, count);
            for (const SplitRule rule : {SplitRule::Quarter, SplitRule::Bare}) {
                const auto split = sweep_split(all, whole_of(all), rule, scratch);
                ASSERT_TRUE(split);
                const std::size_t side = rule == SplitRule::Quarter ? (count + 3) / 4 : 1;
                EXPECT_NEAR(segment_sum(all, split->axis, sides_of(all, *split)),
                            least_sum(all, side),
                            1e-6);
                EXPECT_GE(split->left_count, side);
                EXPECT_LE(split->left_count, count - side);
            }
        }
    }
}

TEST(BuildSplit, TheSweepOfFewTrianglesEqualsTheSweep) {
    std::mt19937_64 random(2);
    SweepScratch scratch;
    for (std::size_t count = 2; count <= few_triangles_max; ++count) {
        for (int round = 0; round < 50; ++round) {
            SCOPED_TRACE(testing::Message() << count << ' ' << round);
            const auto all = random_projections(random, count);
            for (const SplitRule rule : {SplitRule::Quarter, SplitRule::Bare}) {
                const auto split = sweep_split(all, whole_of(all), rule, scratch);
                const auto few = sweep_few(all, whole_of(all), rule);
                ASSERT_TRUE(split);
                ASSERT_TRUE(few);
                ASSERT_EQ(few->left_count, split->left_count);
                const auto goes_left = sides_of(all, *split);
                for (std::size_t i = 0; i < count; ++i) {
                    ASSERT_EQ((few->left >> i & 1) != 0, goes_left[i]);
                }
            }
        }
    }
}

TEST(BuildSplit, BinsOfOneTriangleEachEqualTheSweep) {
    std::mt19937_64 random(3);
    SweepScratch scratch;
    for (int round = 0; round < 500; ++round) {
        SCOPED_TRACE(testing::Message() << round);
        const auto all = one_in_each_bin(random);
        const auto swept = sweep_split(all, whole_of(all), SplitRule::Quarter, scratch);
        const auto binned = bin_split(all);
        ASSERT_TRUE(swept);
        ASSERT_TRUE(binned);
        EXPECT_TRUE(binned->binned);
        EXPECT_EQ(binned->axis, swept->axis);
        ASSERT_EQ(sides_of(all, *binned), sides_of(all, *swept));
    }
}

TEST(BuildSplit, BinsLeaveAQuarterOnEachSideAndAreNearTheLeastSum) {
    std::mt19937_64 random(4);
    for (const std::size_t count : {33u, 100u, 1000u}) {
        for (int round = 0; round < 20; ++round) {
            SCOPED_TRACE(testing::Message() << count << ' ' << round);
            const auto all = random_projections(random, count);
            const auto split = bin_split(all);
            ASSERT_TRUE(split);
            const std::size_t side = (count + 3) / 4;
            EXPECT_GE(split->left_count, side);
            EXPECT_LE(split->left_count, count - side);
            const double sum = segment_sum(all, split->axis, sides_of(all, *split));
            const double least = least_sum(all, side);
            EXPECT_GE(sum, least - 1e-6);
            EXPECT_LE(sum, least + 3.0 / BinScale::bin_count);
        }
    }
}

TEST(BuildSplit, PiecesOfANodeFillTheSameBins) {
    std::mt19937_64 random(5);
    const auto all = random_projections(random, 1000);
    const Projection whole = whole_of(all);
    Bins first(whole);
    Bins second(whole);
    first.add(std::span(all).first(300));
    second.add(std::span(all).subspan(300));
    second += first;
    SweepScratch scratch;
    const auto split = binned_split(all, whole, second, scratch);
    ASSERT_TRUE(split);
    EXPECT_EQ(sides_of(all, *split), sides_of(all, *bin_split(all)));
}

TEST(BuildSplit, AnAxisOnWhichOneBinHoldsTooManyIsSwept) {
    std::mt19937_64 random(6);
    // A triangle far away on all axes puts the others into one bin.
    auto all = random_projections(random, 200);
    all[77].fill({1000, 1001});
    const auto split = bin_split(all);
    ASSERT_TRUE(split);
    EXPECT_FALSE(split->binned);
    EXPECT_NEAR(segment_sum(all, split->axis, sides_of(all, *split)), least_sum(all, 50), 1e-6);
}

TEST(BuildSplit, NothingTellsEqualTrianglesApart) {
    SweepScratch scratch;
    for (const double size : {0.0, 1e-320}) {
        const std::vector<Projection> all(50, Projection{{{3, 3}, {0, size}, {5, 5}}});
        const Projection whole = whole_of(all);
        const auto few = std::span(all).first(20);
        EXPECT_FALSE(sweep_few(few, whole_of(few), SplitRule::Quarter));
        if (size == 0) {
            EXPECT_FALSE(sweep_split(all, whole, SplitRule::Quarter, scratch));
            EXPECT_FALSE(bin_split(all));
        }
    }
}

} // namespace

} // namespace cd::tests
