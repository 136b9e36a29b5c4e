// Proves that a wide tree holds each triangle once, in boxes that contain it in exact terms: on
// soups, closed surfaces, degenerate and flat meshes, needles, far from the origin, tiny, and with
// mixed sizes. Also proves that bodies it cannot hold are searched without it.

#include "common/tree/wide/wide_tree.hpp"

#include "common/search/brute_force.hpp"
#include "common/search/contact_search.hpp"
#include "common/tree/build/build_fit.hpp"
#include "tests/common/tree/exact_box.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cd::tests {

namespace {

/// Makes needles of length 2000 and width 1e-4 in all directions.
Mesh make_needles(std::mt19937_64& random, std::uint32_t count) {
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        corners.push_back(random_point(random, 1000));
        corners.push_back(random_point(random, 1000));
        corners.push_back(corners.back() + random_point(random, 1e-4));
    }
    return make_soup(std::move(corners));
}

/// Makes triangles of sizes from 2^-60 to 2^44, each size around its own position.
Mesh make_mixture(std::mt19937_64& random, std::uint32_t count) {
    std::vector<Vec3> corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double size = std::ldexp(1.0, static_cast<int>(random() % 105) - 60);
        const Vec3 place = random() % 2 == 0 ? Vec3::Zero() : random_point(random, size * 16);
        for (int k = 0; k < 3; ++k) {
            corners.push_back(place + random_point(random, size));
        }
    }
    return make_soup(std::move(corners));
}

/// Makes a grid of cells in the plane z = 0.
Mesh make_sheet(std::uint32_t cells) {
    std::vector<Vec3> corners;
    const auto at = [](std::uint32_t i, std::uint32_t k) { return Vec3(0.1 * i, 0.1 * k, 0); };
    for (std::uint32_t i = 0; i < cells; ++i) {
        for (std::uint32_t k = 0; k < cells; ++k) {
            corners.insert(corners.end(), {at(i, k), at(i, k + 1), at(i + 1, k)});
            corners.insert(corners.end(), {at(i, k + 1), at(i + 1, k + 1), at(i + 1, k)});
        }
    }
    return make_soup(std::move(corners));
}

ExactMat rows_of(const WideNode& node) {
    ExactMat rows;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            rows[k][c] = Rational(node.columns[c][k]);
        }
    }
    return rows;
}

/// Checks the contract of WideNode for a child's box and a point of it.
bool contains(const WideNode& node, const ExactMat& rows, std::size_t child, const Vec3& point) {
    ExactVec from_origin = exact(point);
    for (std::size_t k = 0; k < 3; ++k) {
        from_origin[k] -= Rational(node.origin[k]);
    }
    const ExactVec place = rows * from_origin;
    for (std::size_t k = 0; k < 3; ++k) {
        const Rational step(node.steps[k]);
        if (place[k] < step * int{node.low[k][child]} ||
            step * int{node.high[k][child]} < place[k]) {
            return false;
        }
    }
    return true;
}

void expect_good_frame(const WideNode& node) {
    const ExactMat rows = rows_of(node);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(node.steps[i], 0);
        EXPECT_EQ(node.columns[i][3], 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational off = dot(rows[i], rows[k]) - (i == k ? 1 : 0);
            EXPECT_LE(abs(off), Rational(axes_error_max));
        }
    }
    EXPECT_EQ(node.steps[3], 1);
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t child = node.count; child < wide_children_max; ++child) {
            EXPECT_EQ(node.low[k][child], 0);
            EXPECT_EQ(node.high[k][child], 0);
        }
    }
}

/// Visits all nodes of a tree and records their triangles and blocks.
class Walk {
  public:
    Walk(const Mesh& mesh, const WideView& tree)
        : mesh_(mesh), tree_(tree), nodes_seen_(tree.nodes.size(), 0) {}

    /// Returns the triangles under a node; expects each in its child's box.
    std::vector<std::uint32_t> visit(std::uint32_t index);

    const Mesh& mesh_;
    const WideView& tree_;
    std::vector<int> nodes_seen_;
    std::vector<std::uint32_t> blocks_; ///< From left to right.
};

std::vector<std::uint32_t> Walk::visit(std::uint32_t index) {
    const WideNode& node = tree_.nodes[index];
    ++nodes_seen_[index];
    EXPECT_GE(node.count, node.is_leaf ? 1 : 2);
    EXPECT_LE(node.count, wide_children_max);
    expect_good_frame(node);
    std::vector<std::vector<std::uint32_t>> of_children;
    if (node.is_leaf) {
        blocks_.push_back(node.first);
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const std::uint32_t place = node.first * block_size + i;
            const std::uint32_t id = tree_.triangles.ids[place];
            EXPECT_EQ(tree_.triangles.corners_at(place), mesh_.corners(id));
            of_children.push_back({id});
        }
    } else {
        EXPECT_GT(node.first, index);
        EXPECT_LE(node.first + node.count, tree_.nodes.size());
        for (std::uint32_t i = 0; i < node.count; ++i) {
            of_children.push_back(visit(node.first + i));
        }
    }
    const ExactMat rows = rows_of(node);
    std::vector<std::uint32_t> all;
    for (std::size_t child = 0; child < of_children.size(); ++child) {
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t id : of_children[child]) {
            const Triangle& corners = mesh_.triangles()[id];
            vertices.insert(vertices.end(), corners.begin(), corners.end());
            all.push_back(id);
        }
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        for (const std::uint32_t vertex : vertices) {
            EXPECT_TRUE(contains(node, rows, child, mesh_.vertices()[vertex]))
                << "node " << index << ", child " << child << ", vertex " << vertex;
        }
    }
    return all;
}

/// Checks all promises of a mesh's wide tree.
void expect_good_tree(const Mesh& mesh) {
    const ObbTree tree = make_tree(mesh);
    const WideView wide = tree.view().wide;
    ASSERT_FALSE(wide.nodes.empty());
    Walk walk(mesh, wide);
    std::vector<std::uint32_t> ids = walk.visit(0);
    std::sort(ids.begin(), ids.end());
    ASSERT_EQ(ids.size(), mesh.triangles().size());
    for (std::uint32_t id = 0; id < ids.size(); ++id) {
        ASSERT_EQ(ids[id], id);
    }
    EXPECT_TRUE(std::ranges::all_of(walk.nodes_seen_, [](int times) { return times == 1; }));
    // Each block belongs to one leaf.
    std::sort(walk.blocks_.begin(), walk.blocks_.end());
    ASSERT_EQ(walk.blocks_.size() + 1, wide.triangles.vertex_begin.size());
    for (std::uint32_t block = 0; block < walk.blocks_.size(); ++block) {
        EXPECT_EQ(walk.blocks_[block], block);
    }
    const bool has_floats = !wide.triangles.floats.empty();
    EXPECT_EQ(has_floats, as_floats(mesh).vertices() == mesh.vertices());
    EXPECT_NE(has_floats, !wide.triangles.doubles.empty());
    for (const WideNode& node : wide.nodes) {
        for (const double coordinate : node.origin) {
            EXPECT_LE(std::abs(coordinate), wide.extent);
            if (has_floats && node.is_leaf) {
                EXPECT_EQ(static_cast<double>(static_cast<float>(coordinate)), coordinate);
            }
        }
    }
}

/// Checks the mesh in doubles and in floats, turned, at positions and sizes of all kinds.
void expect_good_trees(std::mt19937_64& random, const Mesh& mesh) {
    const Pose turn = make_pose(random, 1);
    const Mesh turned = mapped(mesh, [&](const Vec3& vertex) { return turn.apply(vertex); });
    for (const Mesh& one : {mesh,
                            turned,
                            translated(turned, Vec3(1e6, -3e5, 5e5)),
                            scaled(turned, 1e-9),
                            scaled(mesh, 0x1p33)}) {
        expect_good_tree(one);
        expect_good_tree(as_floats(one));
    }
    // Floats cannot distinguish these from a point.
    expect_good_tree(translated(scaled(turned, 1e-4), Vec3(1e6, -3e5, 5e5)));
    expect_good_tree(translated(scaled(mesh, 0x1p-10), Vec3(0, 0x1p20, 0)));
}

TEST(WideTree, HoldsEachKindOfMeshInExactTerms) {
    std::mt19937_64 random(3);
    expect_good_trees(random, make_triangle_soup(random, 60, 0.2));
    expect_good_trees(random, make_triangle_soup(random, 300, 0.2));
    expect_good_trees(random, make_degenerate_soup(random, 200));
    expect_good_trees(random, make_sphere(2));
    expect_good_trees(random, make_gridded_box(Vec3(1, 2, 0.5), 4));
    expect_good_trees(random, make_sheet(9));
    expect_good_trees(random, make_needles(random, 150));
}

TEST(WideTree, HoldsSizesOfEveryOrderSideBySideInExactTerms) {
    for (SeededRandom random : seeds(4)) {
        const Mesh mixture = make_mixture(random, 120);
        expect_good_tree(mixture);
        expect_good_tree(as_floats(mixture));
    }
}

TEST(WideTree, HoldsOneTriangle) {
    std::mt19937_64 random(7);
    const Mesh one = make_triangle_soup(random, 1);
    expect_good_trees(random, one);
    const ObbTree tree = make_tree(one);
    ASSERT_EQ(tree.view().wide.nodes.size(), 1u);
    EXPECT_TRUE(tree.view().wide.nodes[0].is_leaf);
    EXPECT_EQ(contact_pairs(tree, tree, PosePair{}).size(), 1u);
    // A segment, and one along an axis.
    expect_good_tree(make_mesh({Vec3(1, 2, 3), Vec3(2, 4, 4)}, {{0, 1, 1}}));
    expect_good_tree(make_mesh({Vec3(1, 2, 3), Vec3(1, 2, 4)}, {{0, 1, 0}}));
}

TEST(WideTree, NodesAreWellFilled) {
    const ObbTree tree = make_tree(make_sphere(5));
    std::size_t leaves = 0;
    std::size_t triangles = 0;
    std::size_t inner = 0;
    std::size_t children = 0;
    for (const WideNode& node : tree.view().wide.nodes) {
        (node.is_leaf ? leaves : inner) += 1;
        (node.is_leaf ? triangles : children) += node.count;
    }
    EXPECT_EQ(triangles, tree.mesh().triangles().size());
    EXPECT_GT(triangles, 14 * leaves);
    EXPECT_GT(children, 8 * inner);
}

TEST(WideTree, IsTheSameForAnyNumberOfThreadsAndWithoutAPool) {
    std::mt19937_64 random(8);
    // Several tasks of every kind, in doubles and floats; and a mesh of a single task.
    const Mesh soup = make_triangle_soup(random, 20000, 0.02);
    for (const Mesh& mesh : {soup, as_floats(soup), make_sphere(4)}) {
        const ObbTree tree = make_tree(mesh, {.prepare_search = false});
        const WideTree alone(tree.view());
        EXPECT_FALSE(alone.view().nodes.empty());
        for (const unsigned threads : {1u, 2u, 3u, 7u}) {
            SCOPED_TRACE(threads);
            ThreadPool pool(threads);
            expect_same(WideTree(tree.view(), &pool).view(), alone.view());
            expect_same(make_tree(mesh, {}, threads).view().wide, alone.view());
        }
    }
}

TEST(WideTree, BodiesThatItCannotHoldAreSearchedWithoutIt) {
    std::mt19937_64 random(9);
    const Mesh soup = make_triangle_soup(random, 60);
    const Mesh sphere = make_sphere(3);
    const Mesh point = make_mesh({Vec3(1, 2, 3)}, std::vector<Triangle>(20, {0, 0, 0}));
    const auto expect_found = [](const Mesh& mesh, const BuildOptions& options) {
        const ObbTree tree = make_tree(mesh, options);
        EXPECT_TRUE(tree.view().wide.nodes.empty());
        const auto expected = contact_pairs_brute_force(mesh, mesh, PosePair{});
        EXPECT_GE(expected.size(), mesh.triangles().size());
        EXPECT_EQ(contact_pairs(tree, tree, PosePair{}), expected);
        // Wide trees are also unused if only the other body has one.
        const ObbTree other = make_tree(make_sphere(1));
        EXPECT_EQ(contact_pairs(tree, other, PosePair{}),
                  contact_pairs_brute_force(mesh, make_sphere(1), PosePair{}));
    };
    expect_found(scaled(soup, 0x1p60), {});
    expect_found(translated(soup, Vec3(0, 0, 0x1p60)), {});
    expect_found(scaled(soup, 0x1p-60), {});
    expect_found(point, {});
    expect_found(sphere, {.leaf_triangles_max = 1000}); // More than 256 in a leaf.
}

} // namespace

} // namespace cd::tests
