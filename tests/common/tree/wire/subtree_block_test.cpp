// Proves that a binary subtree is decoded bit for bit, that its bytes are as few as documented, and
// that arbitrary bytes do no harm.

#include "common/tree/wire/subtree_block.hpp"

#include "common/core/files/compress.hpp"
#include "common/tree/node_check.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace cd::tests {

namespace {

template <class T>
std::vector<T> copied(std::span<const T> values) {
    return {values.begin(), values.end()};
}

void expect_equal(const TreeView& left, const TreeView& right) {
    EXPECT_EQ(copied(left.nodes), copied(right.nodes));
    EXPECT_EQ(copied(left.vertices), copied(right.vertices));
    EXPECT_EQ(copied(left.triangles), copied(right.triangles));
    EXPECT_EQ(copied(left.triangle_ids), copied(right.triangle_ids));
}

} // namespace

TEST(Subtree, HoldsTheTrianglesUnderItsNode) {
    std::mt19937_64 random(1);
    for (const Mesh& mesh : {make_sphere(2), make_degenerate_soup(random, 80)}) {
        const ObbTree tree = make_tree(mesh);
        std::set<std::uint32_t> ids;
        for (const std::uint32_t node : cut_nodes(tree, 4)) {
            const Subtree subtree = extract_subtree(tree, node);
            const TreeView view = subtree.view();
            ASSERT_EQ(view.nodes[0].triangle_count(), tree.nodes()[node].triangle_count());
            for (std::size_t i = 0; i < view.triangles.size(); ++i) {
                const Corners expected = mesh.corners(view.triangle_ids[i]);
                for (std::size_t k = 0; k < 3; ++k) {
                    ASSERT_EQ(view.vertices[view.triangles[i][k]], expected[k]);
                }
            }
            for (const ObbNode& part : view.nodes) {
                ASSERT_TRUE(part.is_leaf() || part.right < view.nodes.size());
                ASSERT_LE(part.triangles_end, view.triangles.size());
            }
            ids.insert(view.triangle_ids.begin(), view.triangle_ids.end());
        }
        EXPECT_EQ(ids.size(), mesh.triangles().size());
    }
}

TEST(Subtree, EqualVerticesBecomeOne) {
    const Mesh sphere = make_sphere(2);
    const ObbTree tree = make_tree(unshared(sphere));
    const Subtree subtree = extract_subtree(tree, 0);
    EXPECT_EQ(subtree.view().vertices.size(), sphere.vertices().size());
}

TEST(SubtreeBlock, ComesBackAsItWas) {
    std::mt19937_64 random(2);
    const std::vector<Mesh> meshes{make_sphere(2),
                                   make_box(Vec3(1, 2, 3)),
                                   make_triangle_soup(random, 100),
                                   make_degenerate_soup(random, 100),
                                   translated(make_sphere(1), Vec3(1e7, -1e7, 0))};
    for (const Mesh& mesh : meshes) {
        for (const BoxKind boxes : {BoxKind::Obb, BoxKind::Aabb}) {
            const ObbTree tree = make_tree(mesh, {.boxes = boxes});
            for (const std::uint32_t node : cut_nodes(tree, 2)) {
                const Subtree subtree = extract_subtree(tree, node);
                const Bytes bytes = encode_subtree(subtree);
                const auto decoded = decode_subtree(bytes);
                ASSERT_TRUE(decoded) << decoded.error().detail;
                expect_equal(decoded.value().view(), subtree.view());
                EXPECT_EQ(encode_subtree(decoded.value()), bytes);
            }
        }
    }
}

TEST(SubtreeBlock, FloatMeshesTravelAsFloats) {
    const ObbTree tree = make_tree(as_floats(make_sphere(2)));
    const Subtree subtree = extract_subtree(tree, 0);
    const Bytes bytes = encode_subtree(subtree);
    const auto decoded = decode_subtree(bytes);
    ASSERT_TRUE(decoded);
    expect_equal(decoded.value().view(), subtree.view());
    // The flag of doubles.
    EXPECT_EQ(std::to_integer<int>(bytes[1]) & 1, 0);
    const ObbTree doubles = make_tree(make_sphere(2));
    EXPECT_EQ(std::to_integer<int>(encode_subtree(extract_subtree(doubles, 0))[1]) & 1, 1);
}

TEST(SubtreeBlock, IndicesGrowWithTheVertices) {
    // Soup with so many corners that 16 bits just suffice, or just do not.
    for (const std::uint32_t triangles : {21845u, 21846u}) {
        std::mt19937_64 random(4);
        const ObbTree tree = make_tree(make_triangle_soup(random, triangles, 0.01));
        const Subtree subtree = extract_subtree(tree, 0);
        const auto decoded = decode_subtree(encode_subtree(subtree));
        ASSERT_TRUE(decoded) << decoded.error().detail;
        EXPECT_EQ(copied(decoded.value().view().triangles), copied(subtree.view().triangles));
    }
}

TEST(SubtreeBlock, IsCompact) {
    // Boxes are most of a block; the figures are for this size of leaves.
    const ObbTree tree = make_tree(as_floats(make_sphere(5)), {.leaf_triangles_max = 4});
    std::size_t plain = 0;
    std::size_t compressed = 0;
    for (const std::uint32_t node : cut_nodes(tree, 4)) {
        const Bytes bytes = encode_subtree(extract_subtree(tree, node));
        plain += bytes.size();
        compressed += compress(bytes, compression_level_geometry).size();
    }
    const auto triangles = static_cast<double>(tree.mesh().triangles().size());
    const double plain_each = static_cast<double>(plain) / triangles;
    const double compressed_each = static_cast<double>(compressed) / triangles;
    RecordProperty("bytes_per_triangle", std::to_string(plain_each));
    RecordProperty("bytes_per_triangle_compressed", std::to_string(compressed_each));
    EXPECT_LT(plain_each, 80);
    EXPECT_LT(compressed_each, 60);
}

TEST(SubtreeBlock, RefusesEveryTruncation) {
    const ObbTree tree = make_tree(make_sphere(1));
    expect_no_other_length(encode_subtree(extract_subtree(tree, 0)), decode_subtree);
}

TEST(SubtreeBlock, RefusesCountsThatTheBytesDoNotJustify) {
    const ObbTree tree = make_tree(make_sphere(1));
    const Bytes good = encode_subtree(extract_subtree(tree, 0));
    for (const std::size_t place : {2u, 6u, 10u}) {
        for (const std::uint8_t high : {0x01, 0x7f, 0xff}) {
            Bytes bytes = good;
            bytes[place + 3] = std::byte{high};
            EXPECT_FALSE(decode_subtree(bytes));
        }
        Bytes bytes = good;
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(place), 4, std::byte{0});
        EXPECT_FALSE(decode_subtree(bytes));
    }
}

TEST(SubtreeBlock, DamageNeverMakesAViewThatLeavesItsArrays) {
    const ObbTree tree = make_tree(make_sphere(1));
    const Bytes good = encode_subtree(extract_subtree(tree, 0));
    std::mt19937_64 random(9);
    std::size_t decoded_count = 0;
    for (int round = 0; round < 20'000; ++round) {
        Bytes bytes = good;
        // Half of the damage hits the shape and the corners, which are at the end.
        const std::size_t from = round % 2 == 0 ? 0 : bytes.size() * 3 / 4;
        flip_bits(random, bytes, from, bytes.size());
        const auto decoded = decode_subtree(bytes);
        if (!decoded) {
            continue;
        }
        ++decoded_count;
        const TreeView view = decoded.value().view();
        ASSERT_TRUE(is_tree_over(view.nodes, view.triangles.size()));
        ASSERT_TRUE(std::ranges::all_of(view.nodes, is_valid_box));
        for (const Triangle& triangle : view.triangles) {
            for (const std::uint32_t vertex : triangle) {
                ASSERT_LT(vertex, view.vertices.size());
            }
        }
    }
    EXPECT_GT(decoded_count, 100u);
}

} // namespace cd::tests
