// Proves that a wide tree is decoded bit for bit, including boxes, which are not sent; that its
// bytes are as few as documented; and that arbitrary bytes end in an error or a valid tree, in
// memory they justify.

#include "common/tree/wire/wide_block.hpp"

#include "common/core/files/compress.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/wide/wide_check.hpp"
#include "common/tree/wide/wide_descent.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cd::tests {
namespace {

ObbTree make_binary_tree(const Mesh& mesh) {
    return make_tree(mesh, {.prepare_search = false});
}

std::vector<Bytes> blocks_of(const ObbTree& tree, std::uint32_t depth) {
    std::vector<Bytes> blocks;
    for (const std::uint32_t node : cut_nodes(tree, depth)) {
        blocks.push_back(encode_subtree(extract_subtree(tree, node, SubtreeForm::Wide)));
    }
    return blocks;
}

/// Checks what a descent relies on, except the ids, which the block's hash protects.
void expect_walkable(const WideTree& tree) {
    const WideView view = tree.view();
    const TriangleBlocks& blocks = view.triangles;
    std::vector<std::uint32_t> ids(blocks.ids.size(), 0);
    std::uint32_t next = 0;
    for (const WideNode& node : view.nodes) {
        for (std::uint32_t i = 0; node.is_leaf && i < node.count; ++i) {
            ids[block_size * node.first + i] = next++;
        }
    }
    WideView renamed = view;
    renamed.triangles.ids = ids;
    const Status checked = check_wide_tree(renamed, next);
    ASSERT_TRUE(checked) << checked.error().detail;
}

} // namespace

TEST(WideBlock, ComesBackBitForBit) {
    std::mt19937_64 random(2);
    const std::vector<Mesh> meshes = {
        make_sphere(3),
        as_floats(make_sphere(4)),
        make_box(Vec3(1, 2, 3)),
        make_triangle_soup(random, 300),
        make_degenerate_soup(random, 300),
        as_floats(make_degenerate_soup(random, 300)),
        translated(make_sphere(2), Vec3(1e7, -1e7, 0)),
        make_mesh({{0, 0, 0}, {-0.0, 0, 0}, {1, 0, -0.0}}, {{0, 1, 2}, {0, 0, 1}})};
    for (const Mesh& mesh : meshes) {
        const ObbTree tree = make_binary_tree(mesh);
        for (const std::uint32_t depth : {0u, 2u, 5u}) {
            for (const std::uint32_t node : cut_nodes(tree, depth)) {
                const Subtree subtree = extract_subtree(tree, node, SubtreeForm::Wide);
                const Bytes bytes = encode_subtree(subtree);
                const auto decoded = decode_subtree(bytes);
                ASSERT_TRUE(decoded) << decoded.error().detail;
                EXPECT_EQ(decoded.value().form(), SubtreeForm::Wide);
                EXPECT_EQ(decoded.value().triangle_count(), tree.nodes()[node].triangle_count());
                expect_same(decoded.value().view().wide, subtree.view().wide);
                EXPECT_EQ(encode_subtree(decoded.value()), bytes);
            }
        }
    }
}

TEST(WideBlock, IsCompact) {
    const ObbTree tree = make_binary_tree(as_floats(make_sphere(6))); // 32,768 triangles.
    std::size_t plain = 0;
    std::size_t compressed = 0;
    for (const Bytes& bytes : blocks_of(tree, 6)) {
        plain += bytes.size();
        compressed += compress(bytes, compression_level_geometry).size();
    }
    const auto triangles = static_cast<double>(tree.mesh().triangles().size());
    EXPECT_LT(static_cast<double>(plain) / triangles, 16);
    EXPECT_LT(static_cast<double>(compressed) / triangles, 12);
}

TEST(WideBlock, RefusesEveryTruncation) {
    for (const Mesh& mesh : {make_sphere(2), as_floats(make_sphere(2))}) {
        expect_no_other_length(blocks_of(make_binary_tree(mesh), 0).front(), decode_subtree);
    }
}

TEST(WideBlock, RefusesNodesThatAreNoTree) {
    // Version, flags, nodes, vertices, then nodes: a chain of single children, too deep, too many.
    const auto block = [](std::initializer_list<unsigned> numbers) {
        Bytes bytes;
        for (const unsigned number : numbers) {
            bytes.push_back(static_cast<std::byte>(number));
        }
        bytes.resize(bytes.size() + 40);
        return bytes;
    };
    EXPECT_FALSE(decode_wide_block(block({2, 0, 0, 3})));
    EXPECT_FALSE(decode_wide_block(block({2, 0, 2, 3, 0, 16})));
    EXPECT_FALSE(decode_wide_block(block({2, 0, 2, 3, 1, 16})));
    EXPECT_FALSE(decode_wide_block(block({2, 0, 4, 3, 1, 16, 16, 16})));
    EXPECT_FALSE(decode_wide_block(block({2, 0x80, 1, 3, 16})));
    EXPECT_FALSE(decode_wide_block(block({2, 0x0a, 1, 3, 16})));
    EXPECT_FALSE(decode_wide_block(block({2, 0, 0xff, 0xff, 0xff, 0x7f, 3, 16})));
    Bytes deep = block({2, 0, 0x91, 0x03, 3}); // 401 nodes, each with a leaf and the next.
    deep.resize(5);
    for (int i = 0; i < 200; ++i) {
        deep.push_back(std::byte{1});
        deep.push_back(std::byte{16});
    }
    deep.push_back(std::byte{16});
    deep.resize(deep.size() + 4000);
    EXPECT_FALSE(decode_wide_block(deep));
}

TEST(WideBlock, DamageNeverMakesATreeThatLeavesItsArrays) {
    std::mt19937_64 random(9);
    for (const Mesh& mesh : {make_sphere(2), as_floats(make_sphere(3))}) {
        const Bytes good = blocks_of(make_binary_tree(mesh), 0).front();
        std::size_t decoded_count = 0;
        for (int round = 0; round < 10'000; ++round) {
            Bytes bytes = good;
            // A third of the damage hits the beginning.
            const std::size_t room = round % 3 == 0 ? 60 : bytes.size();
            flip_bits(random, bytes, 0, room);
            const auto decoded = decode_wide_block(bytes);
            if (decoded) {
                ++decoded_count;
                expect_walkable(decoded.value());
                EXPECT_LT(decoded.value().memory_bytes(), 150 * bytes.size());
            }
        }
        EXPECT_GT(decoded_count, 1000u);
    }
}

TEST(WideBlock, AnyCoordinatesMakeBoxes) {
    // Vertices of any permitted size, flat, tiny and huge side by side: no step may overflow a
    // byte. The decoded tree equals a built one.
    std::mt19937_64 random(5);
    for (int round = 0; round < 300; ++round) {
        std::vector<Vec3> corners;
        const auto coordinate = [&] {
            const int exponent = static_cast<int>(random() % 200) - 151;
            const double size = static_cast<float>(uniform(random, -1, 1));
            return random() % 4 == 0 ? 0.0 : std::ldexp(size, std::min(exponent, 49));
        };
        for (std::uint32_t i = 0; i < 3 * 40; ++i) {
            const double same = coordinate();
            corners.emplace_back(coordinate(), round % 2 == 0 ? same : 1.0, coordinate());
        }
        const ObbTree tree = make_binary_tree(make_soup(std::move(corners)));
        const Subtree subtree = extract_subtree(tree, 0, SubtreeForm::Wide);
        const auto decoded = decode_subtree(encode_subtree(subtree));
        ASSERT_TRUE(decoded) << decoded.error().detail;
        expect_same(decoded.value().view().wide, subtree.view().wide);
    }
}

} // namespace cd::tests
