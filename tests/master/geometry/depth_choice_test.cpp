// Proves, on trees and on invented cuts, that the chosen depth is the least with blocks small
// enough; that it never decreases as meshes grow; that small meshes stay whole; and that roots and
// depth stay within their bounds.
#include "master/geometry/depth_choice.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cd::tests {
namespace {

constexpr double bytes = limits::wide_block_bytes_per_triangle;
constexpr double wanted = limits::block_bytes_wanted;

ObbTree tree_of_mesh(Mesh mesh) {
    ThreadPool pool(1);
    BuildOptions options;
    options.prepare_search = false;
    return build_tree(share(std::move(mesh)), options, pool);
}

/// Halves each root as long as it has more than one triangle.
std::vector<CutSize> even_cuts(double triangles) {
    std::vector<CutSize> cuts;
    for (std::uint64_t roots = 1; cuts.size() <= limits::distribution_depth_max; roots *= 2) {
        cuts.push_back({roots, triangles / static_cast<double>(roots)});
        if (cuts.back().triangles <= 1 || roots > limits::roots_chosen_max) {
            break;
        }
    }
    return cuts;
}

TEST(DepthChoice, SizesAreThoseOfTheCuts) {
    const ObbTree tree = tree_of_mesh(make_torus(1, 0.4, 60, 30));
    const auto sizes = cut_sizes(tree);
    ASSERT_GT(sizes.size(), 5u);
    for (std::uint32_t depth = 0; depth < sizes.size(); ++depth) {
        const TreeTop top = cut_tree(tree, depth);
        ASSERT_EQ(sizes[depth].roots, top.root_count()) << depth;
        double mean = 0;
        for (RootIndex root = 0; root < top.root_count(); ++root) {
            const double count = top.triangles_under(root);
            mean += count * count / static_cast<double>(tree.mesh().triangles().size());
        }
        EXPECT_NEAR(sizes[depth].triangles, mean, 1e-9 * mean) << depth;
    }
}

TEST(DepthChoice, ATreeThatEndsIsNotCutDeeper) {
    const ObbTree tree = tree_of_mesh(make_box({1, 1, 1}));
    const auto sizes = cut_sizes(tree);
    EXPECT_LE(sizes.size(), 5u);
    EXPECT_EQ(sizes.back().roots, cut_tree(tree, 20).root_count());
    EXPECT_EQ(choose_depth(sizes, 1e9), sizes.size() - 1) << "as deep as it goes";
}

TEST(DepthChoice, SmallMeshesAreOneBlock) {
    for (const int subdivisions : {0, 2, 4}) {
        EXPECT_EQ(choose_depth(tree_of_mesh(make_sphere(subdivisions)), SubtreeForm::Wide), 0u);
    }
    EXPECT_EQ(choose_depth(even_cuts(wanted / bytes), bytes), 0u);
    EXPECT_EQ(choose_depth(even_cuts(wanted / bytes + 1), bytes), 1u);
}

TEST(DepthChoice, ALargerMeshIsNotCutLess) {
    std::uint32_t before = 0;
    for (int subdivisions = 0; subdivisions <= 7; ++subdivisions) {
        const std::uint32_t depth =
            choose_depth(tree_of_mesh(make_sphere(subdivisions)), SubtreeForm::Wide);
        EXPECT_GE(depth, before) << subdivisions;
        before = depth;
    }
    EXPECT_GT(before, 3u) << "then this shows little";
    before = 0;
    for (double triangles = 1; triangles < 1e10; triangles *= 1.3) {
        const std::uint32_t depth = choose_depth(even_cuts(triangles), bytes);
        EXPECT_GE(depth, before) << triangles;
        before = depth;
    }
}

TEST(DepthChoice, BlocksAreAsWantedUntilThereWouldBeTooManyRoots) {
    for (double triangles = 1; triangles < 1e10; triangles *= 1.3) {
        const auto cuts = even_cuts(triangles);
        const std::uint32_t depth = choose_depth(cuts, bytes);
        ASSERT_LT(depth, cuts.size());
        EXPECT_LE(cuts[depth].roots, limits::roots_chosen_max);
        const bool is_small_enough = cuts[depth].triangles * bytes <= wanted;
        EXPECT_TRUE(is_small_enough || 2 * cuts[depth].roots > limits::roots_chosen_max);
        EXPECT_TRUE(depth == 0 || cuts[depth - 1].triangles * bytes > wanted) << "not the least";
    }
    // However two bodies overlap, no scenario exceeds the limit on root pairs.
    EXPECT_LE(limits::roots_chosen_max * limits::roots_chosen_max, limits::root_pairs_max);
}

TEST(DepthChoice, UnevenCutsAreJudgedByWhereTheTrianglesAre) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 1000; ++round) {
        // In any tree, roots grow and blocks shrink with the depth, in arbitrary steps.
        std::vector<CutSize> cuts{{1, std::pow(10, 1 + 8 * uniform(random, 0, 1))}};
        while (cuts.size() <= random() % limits::distribution_depth_max) {
            cuts.push_back({cuts.back().roots + 1 + random() % cuts.back().roots,
                            cuts.back().triangles * (0.4 + 0.6 * uniform(random, 0, 1))});
        }
        const std::uint32_t depth = choose_depth(cuts, bytes);
        ASSERT_LT(depth, cuts.size());
        EXPECT_TRUE(depth == 0 || cuts[depth].roots <= limits::roots_chosen_max);
        EXPECT_TRUE(depth == 0 || cuts[depth - 1].triangles * bytes > wanted);
        EXPECT_TRUE(depth + 1 == cuts.size() || cuts[depth].triangles * bytes <= wanted ||
                    cuts[depth + 1].roots > limits::roots_chosen_max);
    }
}

} // namespace
} // namespace cd::tests
