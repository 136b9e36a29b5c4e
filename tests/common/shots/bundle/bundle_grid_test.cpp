// Proves that the kernel for lines of a grid marks what the kernel for all lines does: each line
// that passes, and of the open pairs those in a triangle's box.
#include "common/shots/bundle/bundle_frame.hpp"
#include "common/shots/bundle/bundle_grid_kernel.hpp"
#include "tests/support/bundle_cases.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace cd::tests {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>; ///< Number of a placed triangle, and line.

struct Marked {
    std::map<Pair, bool> passes; ///< Whether the triangle turns left.
    std::set<Pair> open;
};

/// Collects what a kernel marks in one block, in as many calls as it takes.
template <class Kernel>
Marked marked_by(const Kernel& kernel,
                 const BlockAcross& placed,
                 const BundleAcross& bundle,
                 const LineRows& rows) {
    Marked all;
    MarkedPairs marked;
    LineWalk walk;
    for (bool is_done = false; !is_done;) {
        is_done = kernel(placed, bundle, rows, walk, marked);
        for (std::uint32_t run = 0; run < marked.runs; ++run) {
            const auto& [triangle, begin, turns_left] = marked.of_triangles[run];
            for (std::uint32_t i = begin; i < marked.end_of(run); ++i) {
                const bool is_new =
                    all.passes.insert({{triangle, marked.passing[i]}, turns_left}).second;
                EXPECT_TRUE(is_new);
            }
        }
        for (std::uint32_t i = 0; i < marked.open; ++i) {
            EXPECT_TRUE(all.open.insert({marked.open_triangles[i], marked.open_lines[i]}).second);
        }
    }
    return all;
}

/// Counts of pairs.
struct Compared {
    std::size_t passes = 0;
    std::size_t open = 0;
    std::size_t left_out = 0; ///< Open pairs outside of boxes.
};

void compare(const Mesh& mesh, const PosePair& poses, const ParallelLines& lines, Compared& sum) {
    const ObbTree tree = make_tree(mesh);
    const WideView view = tree.view().wide;
    const BundleFrame frame(poses, lines.axis(), std::max(view.extent, view.triangles.reach));
    const BundleAcross bundle = bundle_across(lines, frame.error(), 1);
    const LineRows rows = lines.rows();
    BlockAcross placed;
    for (const WideNode& node : view.nodes) {
        if (!node.is_leaf) {
            continue;
        }
        place_block(view.triangles, node.first, (1u << node.count) - 1, frame, bundle, placed);
        const Marked expected = marked_by(mark_pairs, placed, bundle, rows);
        const Marked marked = marked_by(mark_grid_pairs, placed, bundle, rows);
        EXPECT_EQ(marked.passes, expected.passes);
        for (const Pair& pair : marked.open) {
            EXPECT_TRUE(expected.open.contains(pair));
        }
        for (const auto& [triangle, line] : expected.open) {
            bool is_in_box = true;
            for (std::size_t which = 0; which < 2; ++which) {
                const double x = rows.across[which][line];
                is_in_box = is_in_box && x >= placed.low[which][triangle] &&
                            x <= placed.high[which][triangle];
            }
            EXPECT_TRUE(!is_in_box || marked.open.contains({triangle, line}));
            sum.left_out += is_in_box ? 0 : 1;
        }
        sum.passes += marked.passes.size();
        sum.open += marked.open.size();
    }
}

} // namespace

TEST(BundleGrid, MarksWhatTheKernelForAllLinesDoes) {
    on_every_target([](SimdTarget) {
        Compared sum;
        for (SeededRandom random : seeds(raised(30))) {
            const std::array<int, 2> counts{static_cast<int>(1 + random() % 40),
                                            static_cast<int>(1 + random() % 40)};
            const double spacing = std::ldexp(1.0, -static_cast<int>(1 + random() % 5));
            const ObbTree tree =
                make_tree(mesh_of(grid_lines(random, random() % 3, counts, spacing, 0, {3, -3})));
            ParallelLines lines;
            ASSERT_TRUE(lines.assign(tree.view().wide));
            ASSERT_TRUE(lines.is_grid());
            PosePair poses;
            if (random() % 2 == 0) {
                poses = {make_pose(random, 0.3), make_pose(random, 0.3)};
            }
            compare(make_sphere(static_cast<int>(random() % 4)), poses, lines, sum);
            compare(make_gridded_box(Vec3(1, 1, 1), 4), poses, lines, sum);
        }
        EXPECT_GT(sum.passes, 5000u);
        EXPECT_GT(sum.open, 1000u);
    });
}

TEST(BundleGrid, LinesThatEndInABoxStayOpen) {
    std::mt19937_64 random(1);
    for (const double spacing : {0.1, 1.5}) {
        const ObbTree tree =
            make_tree(mesh_of(grid_lines(random, 0, {9, 9}, spacing, 0, {0.01, -3})));
        ParallelLines lines;
        ASSERT_TRUE(lines.assign(tree.view().wide));
        Compared sum;
        compare(make_sphere(1), {}, lines, sum);
        EXPECT_GT(sum.open, 0u);
    }
}

TEST(BundleGrid, DuplicateLinesAreNoGrid) {
    const auto line = [](double y, double z) { return Segment{Vec3(3, y, z), Vec3(-3, y, z)}; };
    const ObbTree tree = make_tree(mesh_of({line(0, 0), line(0, 1), line(1, 0), line(1, 0)}));
    ParallelLines lines;
    ASSERT_TRUE(lines.assign(tree.view().wide));
    EXPECT_FALSE(lines.is_grid());
}

} // namespace cd::tests
