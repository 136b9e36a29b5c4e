// Proves that a tree holds every triangle once, in boxes that contain them in exact terms, that it
// does not depend on the number of threads, and that no input crashes the builder.

#include "common/tree/build/build_fit.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace cd::tests {

namespace {

ObbTree build(const Mesh& mesh, const BuildOptions& options = {}) {
    return make_tree(mesh, options, 2);
}

void expect_every_triangle_once(const ObbTree& tree) {
    std::vector<std::uint32_t> ids(tree.triangle_ids().begin(), tree.triangle_ids().end());
    std::sort(ids.begin(), ids.end());
    std::vector<std::uint32_t> all(tree.mesh().triangles().size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(ids, all);
    const TreeView view = tree.view();
    for (std::size_t i = 0; i < view.triangles.size(); ++i) {
        ASSERT_EQ(view.triangles[i], tree.mesh().triangles()[view.triangle_ids[i]]);
    }
}

/// Expects preorder with consecutive ranges: the left child follows its parent, the right one the
/// left's subtree.
void expect_preorder(std::span<const ObbNode> nodes, std::size_t triangles) {
    ASSERT_EQ(nodes[0].triangles_begin, 0u);
    ASSERT_EQ(nodes[0].triangles_end, triangles);
    std::vector<std::uint32_t> ends(nodes.size(), 0); // One past the last node of each subtree.
    for (std::size_t i = nodes.size(); i-- > 0;) {
        const ObbNode& node = nodes[i];
        ASSERT_LT(node.triangles_begin, node.triangles_end);
        if (node.is_leaf()) {
            ends[i] = static_cast<std::uint32_t>(i + 1);
            continue;
        }
        ASSERT_GT(node.right, i + 1);
        ASSERT_LT(node.right, nodes.size());
        ASSERT_EQ(ends[i + 1], node.right);
        ASSERT_EQ(nodes[i + 1].triangles_begin, node.triangles_begin);
        ASSERT_EQ(nodes[i + 1].triangles_end, nodes[node.right].triangles_begin);
        ASSERT_EQ(nodes[node.right].triangles_end, node.triangles_end);
        ends[i] = ends[node.right];
    }
    ASSERT_EQ(ends[0], nodes.size());
}

void expect_sound_frames(std::span<const ObbNode> nodes) {
    for (const ObbNode& node : nodes) {
        const ExactMat f = axes_of(node);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Rational off = dot(f[i], f[k]) - (i == k ? 1 : 0);
                ASSERT_LE(abs(off), Rational(axes_error_max));
            }
            ASSERT_TRUE(std::isfinite(node.center[i]));
            ASSERT_GT(node.half[i], 0.0F);
        }
    }
}

void expect_quarters(std::span<const ObbNode> nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].is_leaf()) {
            const std::uint32_t left = nodes[i + 1].triangle_count();
            const std::uint32_t right = nodes[nodes[i].right].triangle_count();
            ASSERT_GE(4 * std::min(left, right) + 2, left + right);
        }
    }
}

void expect_vertices_inside(const ObbTree& tree) {
    const TreeView view = tree.view();
    for (const ObbNode& node : view.nodes) {
        for (std::uint32_t i = node.triangles_begin; i < node.triangles_end; ++i) {
            for (const std::uint32_t vertex : view.triangles[i]) {
                ASSERT_TRUE(contains(node, view.vertices[vertex]));
            }
        }
    }
}

void expect_sound(const ObbTree& tree) {
    expect_every_triangle_once(tree);
    expect_preorder(tree.nodes(), tree.mesh().triangles().size());
    expect_sound_frames(tree.nodes());
    expect_vertices_inside(tree);
}

Mesh grown(const Mesh& mesh, const Vec3& factors, const Vec3& offset) {
    return mapped(mesh, [&](const Vec3& v) { return Vec3(v.cwiseProduct(factors) + offset); });
}

Mesh scaled_soup(std::uint64_t seed, double scale, const Vec3& offset) {
    std::mt19937_64 random(seed);
    return grown(make_triangle_soup(random, 60), Vec3::Constant(scale), offset);
}

TEST(Build, HoldsEveryTriangleInsideItsBoxes) {
    std::mt19937_64 random(1);
    expect_sound(build(make_triangle_soup(random, 150)));
    expect_sound(build(make_degenerate_soup(random, 150)));
    expect_sound(build(make_sphere(2)));
    expect_sound(build(make_gridded_box(Vec3(1, 2, 3), 4)));
    expect_sound(build(make_torus(3, 1, 16, 8), {.leaf_triangles_max = 1}));
    expect_sound(build(make_torus(3, 1, 16, 8), {.boxes = BoxKind::Aabb}));
    expect_sound(build(make_torus(3, 1, 16, 8), {.rule = SplitRule::Bare}));
}

TEST(Build, HoldsTinyHugeAndDistantTriangles) {
    for (const double scale : {1e-320, 1e-300, 1e-160, 1e-40, 1e-30, 1e30, 1e38, 0x1p400, 1e300}) {
        SCOPED_TRACE(testing::Message() << "scale " << scale);
        expect_sound(build(scaled_soup(1, scale, Vec3::Zero())));
    }
    expect_sound(build(scaled_soup(2, 1e-3, Vec3(1e7, -3e7, 12345.678))));
    expect_sound(build(scaled_soup(3, 1e-12, Vec3(1, 1, 1))));
    expect_sound(build(scaled_soup(4, 1e-3, Vec3(1e300, 0, 1e-300))));
    // The full range of doubles, where even differences overflow.
    expect_sound(build(
        make_mesh({Vec3(-1.7e308, 1.7e308, 0), Vec3(1.7e308, -1.7e308, 1), Vec3(0, 0, 1.7e308)},
                  {{0, 1, 2}, {0, 0, 0}, {1, 1, 2}, {2, 2, 2}, {0, 1, 1}, {1, 2, 2}})));
}

TEST(Build, HoldsHostileMeshes) {
    std::mt19937_64 random(9);
    const Mesh soup = make_triangle_soup(random, 40);
    const Mesh lattice = make_degenerate_soup(random, 40);
    const Vec3 zero = Vec3::Zero();
    for (const BoxKind boxes : {BoxKind::Obb, BoxKind::Aabb}) {
        const auto expect_held = [&](const Mesh& mesh) {
            expect_sound(build(mesh, {.boxes = boxes, .leaf_triangles_max = 1}));
        };
        // Needles and flakes, unturned and turned by their own spread.
        expect_held(grown(soup, Vec3(1e12, 1, 1), zero));
        expect_held(grown(soup, Vec3(1, 1e-12, 1e6), Vec3(5, 6, 7)));
        // A millimetre in UTM coordinates, in doubles and in the floats it collapses to.
        const Vec3 utm(691'607.86, 5'334'760.38, 519.2);
        const Mesh building = grown(soup, Vec3(1e-3, 1e-3, 1e-3), utm);
        expect_held(building);
        expect_held(as_floats(building));
        // Sizes of a millionth beside a million, degenerate shapes far away, and steps of one ulp.
        expect_held(join({grown(soup, Vec3::Constant(1e-6), zero),
                          grown(soup, Vec3::Constant(1e6), Vec3(3e6, 0, 1))}));
        expect_held(grown(lattice, Vec3::Constant(1e-3), Vec3(-1e7, 1e7, 1e7 / 3)));
        expect_held(grown(lattice, Vec3::Constant(0x1p-52), Vec3(1, 2, -1)));
        // Half sizes on both sides of the least and the largest float.
        expect_held(grown(soup, Vec3(0x1p-126, 0x1p-127, 0x1p-149), zero));
        expect_held(grown(soup, Vec3(0x1p128, 0x1p127, 1), Vec3(0, 0, 0x1p128)));
        expect_held(grown(soup, Vec3(0x1p999, 0x1p-1074, 0x1p-1022), zero));
        expect_held(grown(lattice, Vec3(0x1p400, 0x1p-400, 0), zero));
    }
}

TEST(Build, KeepsSmallFeaturesApartFarFromTheOrigin) {
    const ObbTree tree = build(scaled_soup(2, 1e-3, Vec3(1e7, -3e7, 12345.678)));
    for (const ObbNode& node : tree.nodes()) {
        EXPECT_LT(*std::max_element(node.half.begin(), node.half.end()), 3e-3F);
    }
}

TEST(Build, IsTheSameForAnyNumberOfThreads) {
    std::mt19937_64 random(3);
    // Several tasks, and waves of one and of several nodes.
    const Mesh mesh = make_triangle_soup(random, 30000, 0.02);
    const ObbTree one = make_tree(mesh);
    for (const unsigned threads : {2u, 3u, 7u}) {
        const ObbTree many = make_tree(mesh, {}, threads);
        EXPECT_TRUE(std::ranges::equal(one.nodes(), many.nodes()));
        EXPECT_TRUE(std::ranges::equal(one.triangle_ids(), many.triangle_ids()));
    }
    expect_every_triangle_once(one);
    expect_preorder(one.nodes(), mesh.triangles().size());
}

TEST(Build, LeavesAQuarterOnEachSide) {
    std::mt19937_64 random(4);
    const Mesh staircase = make_staircase(700);
    for (const Mesh& mesh :
         {make_triangle_soup(random, 500), make_degenerate_soup(random, 500), staircase}) {
        const ObbTree tree = build(mesh, {.leaf_triangles_max = 1});
        expect_quarters(tree.nodes());
        // log(700) / log(4/3).
        EXPECT_LE(tree.depth(), 23u);
    }
}

TEST(Build, LeavesAQuarterOnEachSideOfLargeNodes) {
    std::mt19937_64 random(7);
    // Several pieces at the top. A distant triangle puts all others into one bin on each axis.
    const Mesh soup = make_triangle_soup(random, 10000, 0.02);
    const Mesh far = make_soup({Vec3(1e6, 1e6, 1e6), Vec3(1e6, 1e6, 2e6), Vec3(1e6, 0, 1e6)});
    for (const Mesh& mesh : {soup, join({soup, far})}) {
        for (const std::uint32_t most : {0u, 32u, 1000u, 20000u}) {
            const ObbTree tree = build(mesh, {.sweep_triangles_max = most});
            expect_every_triangle_once(tree);
            expect_preorder(tree.nodes(), mesh.triangles().size());
            expect_quarters(tree.nodes());
        }
    }
}

TEST(Build, TheBareRuleMayGoDeepAndStillEnds) {
    const ObbTree tree =
        build(make_staircase(3000), {.rule = SplitRule::Bare, .leaf_triangles_max = 1});
    EXPECT_GT(tree.depth(), 500u);
    expect_every_triangle_once(tree);
    expect_preorder(tree.nodes(), 3000);
}

TEST(Build, HalvesTrianglesThatCannotBeToldApart) {
    const std::vector<Triangle> same(1000, Triangle{0, 1, 2});
    const Mesh mesh = make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, same);
    const Mesh points = make_mesh({Vec3(1, 2, 3)}, std::vector<Triangle>(200, Triangle{0, 0, 0}));
    for (const SplitRule rule : {SplitRule::Quarter, SplitRule::Bare}) {
        expect_sound(build(points, {.rule = rule}));
        expect_every_triangle_once(build(mesh, {.rule = rule}));
    }
    // Several pieces.
    const Mesh many = make_mesh(mesh.vertices(), std::vector<Triangle>(9000, Triangle{0, 1, 2}));
    expect_quarters(build(many).nodes());
    const Mesh dust = make_mesh({Vec3(1, 2, 3)}, std::vector<Triangle>(9000, Triangle{0, 0, 0}));
    EXPECT_LE(build(dust, {.leaf_triangles_max = 1}).depth(), 14u);
    EXPECT_LE(build(points, {.leaf_triangles_max = 1}).depth(), 8u);
}

TEST(Build, LeavesHoldNoMoreThanAsked) {
    std::mt19937_64 random(5);
    const Mesh mesh = make_triangle_soup(random, 333);
    for (const std::uint32_t most : {1u, 2u, 3u, 8u, 1000u}) {
        const ObbTree tree = build(mesh, {.leaf_triangles_max = most});
        for (const ObbNode& node : tree.nodes()) {
            EXPECT_EQ(node.is_leaf(), node.triangle_count() <= most);
        }
    }
}

TEST(Build, ABoxFitsAFlatTurnedRectangle) {
    std::mt19937_64 random(6);
    const Pose pose = make_pose(random, 1.0);
    const Mesh corners = mapped(make_mesh({{-3, -1, 0}, {3, -1, 0}, {3, 1, 0}, {-3, 1, 0}},
                                          {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}),
                                [&](const Vec3& corner) { return pose.apply(corner); });
    // Both diagonals, so that the corners weigh equally.
    const ObbTree tree = build(corners, {.leaf_triangles_max = 4});
    const ObbNode& box = tree.nodes()[0];
    EXPECT_LT(box.half[0], 1e-6F);
    EXPECT_NEAR(box.half[1], 1.0, 1e-5);
    EXPECT_NEAR(box.half[2], 3.0, 1e-5);
}

TEST(Build, EndsAtWhicheverPollItIsStopped) {
    const auto mesh = share(make_torus(2, 0.7, 200, 100)); // Several waves of large nodes.
    ThreadPool pool(2);
    const ObbTree whole = build_tree(mesh, {}, pool);
    int stop_at = 0;
    for (std::optional<ObbTree> tree; !tree; ++stop_at) {
        int polls = 0;
        tree = build_tree_until([&] { return polls++ >= stop_at; }, mesh, {}, pool);
        if (tree) {
            EXPECT_LE(polls, stop_at);
            EXPECT_TRUE(std::ranges::equal(tree->nodes(), whole.nodes()));
            EXPECT_TRUE(std::ranges::equal(tree->triangle_ids(), whole.triangle_ids()));
        } else {
            EXPECT_EQ(polls, stop_at + 1) << "a stop that was told is not asked again";
        }
    }
    EXPECT_GT(stop_at, 5) << "it is asked between waves and between subtrees";
}

} // namespace

} // namespace cd::tests
