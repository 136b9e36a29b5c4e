// Proves that an upper tree is decoded unchanged, and that invalid bytes are refused.
#include "common/tree/wire/top_block.hpp"

#include "common/tree/cut.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

namespace cd::tests {
namespace {

TreeTop top_of_a_torus(std::uint32_t depth) {
    return cut_tree(make_tree(make_torus(1, 0.4, 40, 20)), depth);
}

TEST(TopBlock, ComesBackAsItWas) {
    for (const std::uint32_t depth : {0u, 1u, 5u, 40u}) {
        const TreeTop top = top_of_a_torus(depth);
        const auto again = decode_top(encode_top(top));
        ASSERT_TRUE(again) << again.error().detail;
        EXPECT_EQ(again.value().nodes, top.nodes);
        EXPECT_EQ(again.value().root_nodes, top.root_nodes);
        EXPECT_EQ(again.value().triangle_count(), 1600u);
    }
}

TEST(TopBlock, TruncatedOrExtendedBytesAreRefused) {
    expect_no_other_length(encode_top(top_of_a_torus(3)), [](std::span<const std::byte> bytes) {
        const auto top = decode_top(bytes);
        EXPECT_TRUE(top || top.error().code == ErrorCode::BadFrame);
        return top.has_value();
    });
}

TEST(TopBlock, BoxesThatCannotBeTestedAreRefused) {
    const auto accepted = [](const std::function<void(ObbNode&)>& change) {
        TreeTop top = top_of_a_torus(3);
        change(top.nodes[3]);
        return decode_top(encode_top(top)).has_value();
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(accepted([&](ObbNode& node) { node.half[1] = infinity; }));
    EXPECT_FALSE(accepted([&](ObbNode& node) { node.half[1] = nan; }));
    EXPECT_FALSE(accepted([&](ObbNode& node) { node.half[1] = -1; }));
    EXPECT_FALSE(accepted([&](ObbNode& node) { node.center[0] = infinity; }));
    EXPECT_FALSE(accepted([&](ObbNode& node) { node.axes[4] = 5; }));
    EXPECT_FALSE(accepted([&](ObbNode& node) { node.axes[8] = nan; }));
}

TEST(TopBlock, ChangedBytesAreRefusedOrGiveATree) {
    const Bytes bytes = encode_top(top_of_a_torus(4));
    std::mt19937_64 random(1);
    std::size_t refused = 0;
    for (int i = 0; i < 3000; ++i) {
        Bytes changed = bytes;
        changed[random() % changed.size()] ^= std::byte{static_cast<unsigned char>(random())};
        const auto top = decode_top(changed);
        refused += top ? 0u : 1u;
        if (!top) {
            continue;
        }
        std::uint32_t end = 0;
        for (RootIndex root = 0; root < top.value().root_count(); ++root) {
            const ObbNode& node = top.value().nodes[top.value().root_nodes[root]];
            ASSERT_EQ(node.triangles_begin, end);
            ASSERT_GT(node.triangles_end, end);
            end = node.triangles_end;
        }
        ASSERT_EQ(end, top.value().triangle_count());
    }
    EXPECT_GT(refused, 100u);
}

} // namespace
} // namespace cd::tests
