#include "common/shots/bundle/parallel_lines.hpp"

#include "tests/support/bundle_cases.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace cd::tests {

namespace {

bool is_parallel(const std::vector<Segment>& lines) {
    const ObbTree tree = make_tree(mesh_of(lines));
    return ParallelLines().assign(tree.view().wide);
}

} // namespace

TEST(ParallelLines, HaveOneAxisAndTheSameEnds) {
    const Segment line{Vec3(0, 1, 2), Vec3(3, 1, 2)};
    EXPECT_TRUE(is_parallel({line}));
    EXPECT_TRUE(is_parallel({line, line}));
    EXPECT_TRUE(is_parallel({line, {Vec3(0, -4, 5), Vec3(3, -4, 5)}}));
    EXPECT_FALSE(is_parallel({line, {Vec3(0, -4, 5), Vec3(2, -4, 5)}})) << "another end";
    EXPECT_FALSE(is_parallel({line, {Vec3(3, -4, 5), Vec3(0, -4, 5)}})) << "the other way";
    EXPECT_FALSE(is_parallel({line, {Vec3(0, -4, 5), Vec3(3, -4, 6)}})) << "slanted";
    EXPECT_FALSE(is_parallel({line, {Vec3(0, -4, 5), Vec3(0, -4, 9)}})) << "another axis";
    EXPECT_FALSE(is_parallel({{Vec3(0, 1, 2), Vec3(0, 1, 2)}})) << "a point";
}

TEST(ParallelLines, AreNotTriangles) {
    const ObbTree tree = make_tree(make_box(Vec3(1, 1, 1)));
    EXPECT_FALSE(ParallelLines().assign(tree.view().wide));
}

TEST(ParallelLines, BinsHoldAllLinesOfABox) {
    int held = 0;
    for (SeededRandom random : seeds(raised(200))) {
        const std::size_t axis = random() % 3;
        const std::array<int, 2> counts{static_cast<int>(1 + random() % 9),
                                        static_cast<int>(1 + random() % 9)};
        const ObbTree tree = make_tree(mesh_of(
            grid_lines(random, axis, counts, 0.25, static_cast<double>(random() % 2), {-1, 5})));
        ParallelLines lines;
        ASSERT_TRUE(lines.assign(tree.view().wide));
        ASSERT_EQ(lines.axis(), axis);
        ASSERT_EQ(lines.ends(), (std::array{-1.0, 5.0}));
        const LineRows rows = lines.rows();
        const Vec3 at = random_point(random, 1.5);
        const double size = uniform(random, 0, 0.6);
        std::set<std::uint32_t> found;
        std::array<std::uint32_t, 2> first{};
        std::array<std::uint32_t, 2> last{};
        for (std::size_t which = 0; which < 2; ++which) {
            const double low = at[static_cast<Eigen::Index>(which)];
            first[which] = lines.bin_of(low, which);
            last[which] = lines.bin_of(low + size, which);
        }
        for (std::uint32_t row = first[1]; row <= last[1]; ++row) {
            for (std::uint32_t i = rows.begin_of(first[0], row);
                 i < rows.begin_of(last[0] + 1, row);
                 ++i) {
                found.insert(i);
            }
        }
        for (std::uint32_t i = 0; i < lines.slots().size(); ++i) {
            const bool is_in = rows.across[0][i] >= at[0] && rows.across[0][i] <= at[0] + size &&
                               rows.across[1][i] >= at[1] && rows.across[1][i] <= at[1] + size;
            ASSERT_TRUE(!is_in || found.contains(i));
            held += is_in ? 1 : 0;
        }
    }
    EXPECT_GT(held, 50);
}

TEST(ParallelLines, ABoxThatHoldsALineIsNeverRefused) {
    int refused = 0;
    for (SeededRandom random : seeds(raised(400))) {
        const auto jitter = static_cast<double>(random() % 2);
        const ObbTree tree =
            make_tree(mesh_of(grid_lines(random, 0, {9, 7}, 0.25, jitter, {-1, 5})));
        ParallelLines lines;
        ASSERT_TRUE(lines.assign(tree.view().wide));
        EXPECT_EQ(lines.is_grid(), jitter == 0);
        const LineRows rows = lines.rows();
        const auto i = static_cast<std::uint32_t>(random() % lines.slots().size());
        const std::array<double, 2> at{rows.across[0][i], rows.across[1][i]};
        const std::array<double, 2> size{uniform(random, 0, 1), uniform(random, 0, 0.3)};
        EXPECT_TRUE(lines.may_hold(at, {at[0] + size[0], at[1] + size[1]}));
        EXPECT_TRUE(lines.may_hold({at[0] - size[0], at[1] - size[1]}, at));
        EXPECT_FALSE(lines.may_hold({3, 3}, {9, 9}));
        refused += lines.may_hold({at[0] + 0.02, at[1] + 0.02}, {at[0] + 0.1, at[1] + 0.1}) ? 0 : 1;
    }
    EXPECT_GT(refused, 100);
}

TEST(ParallelLines, AGridMayHaveAnyShape) {
    std::mt19937_64 random(1);
    for (const std::array<int, 2> counts :
         {std::array{40, 8}, {8, 40}, {64, 64}, {37, 3}, {1, 9}, {9, 1}, {1, 1}}) {
        for (const double stretch : {1.0, 0.1, 7.0}) {
            std::vector<Segment> given = grid_lines(random, 0, counts, 0.3, 0, {-1, 5});
            for (Segment& line : given) {
                line.p.z() *= stretch;
                line.q.z() *= stretch;
            }
            const ObbTree tree = make_tree(mesh_of(given));
            ParallelLines lines;
            ASSERT_TRUE(lines.assign(tree.view().wide));
            ASSERT_TRUE(lines.is_grid());
            for (std::size_t which = 0; which < 2; ++which) {
                const LineSteps& steps = lines.steps(which);
                ASSERT_EQ(steps.count(), static_cast<std::uint32_t>(counts[which]));
                EXPECT_LT(steps.slack, 1e-12);
                for (std::uint32_t i = 0; i < steps.count(); ++i) {
                    const double place = (steps.least[i] - steps.least[0]) * steps.steps_per_length;
                    EXPECT_LE(std::abs(place - i), steps.slack);
                }
            }
        }
    }
}

TEST(ParallelLines, UnevenColumnsAreNoGrid) {
    const auto is_grid = [](double moved) {
        std::vector<Segment> given;
        for (const double y : {0.0, 1.0, 2.0 + moved, 3.0}) {
            for (const double z : {0.0, 1.0, 2.0}) {
                given.push_back({Vec3(-1, y, z), Vec3(1, y, z)});
            }
        }
        const ObbTree tree = make_tree(mesh_of(given));
        ParallelLines lines;
        return lines.assign(tree.view().wide) && lines.is_grid();
    };
    EXPECT_TRUE(is_grid(0));
    EXPECT_TRUE(is_grid(0.005));
    EXPECT_FALSE(is_grid(0.1));
    EXPECT_FALSE(is_grid(-0.5));
}

TEST(ParallelLines, SlotsAreThoseOfTheBlocks) {
    std::mt19937_64 random(1);
    const std::vector<Segment> given = grid_lines(random, 1, {8, 8}, 0.5, 1, {4, -4});
    const ObbTree tree = make_tree(mesh_of(given));
    ParallelLines lines;
    ASSERT_TRUE(lines.assign(tree.view().wide));
    std::set<std::uint32_t> ids;
    for (std::uint32_t i = 0; i < lines.slots().size(); ++i) {
        const std::uint32_t id = tree.view().wide.triangles.ids[lines.slots()[i]];
        EXPECT_EQ(lines.rows().across[0][i], given[id].p.z());
        EXPECT_EQ(lines.rows().across[1][i], given[id].p.x());
        ids.insert(id);
    }
    EXPECT_EQ(ids.size(), given.size());
}

} // namespace cd::tests
