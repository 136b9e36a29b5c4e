// Proves that a wide tree with inconsistent arrays is refused: every index a descent follows is
// checked, so that even a file with right checksums cannot mislead it.

#include "common/tree/wide/wide_check.hpp"

#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace cd::tests {
namespace {

/// The arrays of a wide tree, for tests to change.
struct Arrays {
    explicit Arrays(const WideView& view)
        : nodes(view.nodes.begin(), view.nodes.end()),
          floats(view.triangles.floats.begin(), view.triangles.floats.end()),
          doubles(view.triangles.doubles.begin(), view.triangles.doubles.end()),
          vertex_begin(view.triangles.vertex_begin.begin(), view.triangles.vertex_begin.end()),
          corners(view.triangles.corners.begin(), view.triangles.corners.end()),
          ids(view.triangles.ids.begin(), view.triangles.ids.end()),
          reach(view.triangles.reach),
          extent(view.extent) {}

    [[nodiscard]] WideView view() const {
        return {nodes, {floats, doubles, vertex_begin, corners, ids, reach}, extent};
    }
    [[nodiscard]] WideNode& first_leaf() {
        std::size_t i = 0;
        while (!nodes[i].is_leaf) {
            ++i;
        }
        return nodes[i];
    }

    std::vector<WideNode> nodes;
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<std::uint32_t> vertex_begin;
    std::vector<BlockCorners> corners;
    std::vector<std::uint32_t> ids;
    double reach;
    double extent;
};

class WideCheck : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_GT(tree_.view().wide.nodes.size(), 20u);
        ASSERT_FALSE(tree_.view().wide.nodes[0].is_leaf);
    }
    void expect_refused(const char* what, const std::function<void(Arrays&)>& change) const {
        Arrays arrays(tree_.view().wide);
        change(arrays);
        EXPECT_FALSE(check_wide_tree(arrays.view(), 512)) << what;
    }

    ObbTree tree_ = make_tree(make_sphere(3)); // 512 triangles, in doubles.
};

TEST_F(WideCheck, TakesWhatTheBuilderMakes) {
    EXPECT_TRUE(check_wide_tree(tree_.view().wide, 512));
    EXPECT_TRUE(check_wide_tree(WideView{}, 512));
    std::mt19937_64 random(4);
    for (std::uint32_t count : {1u, 16u, 17u, 3000u}) {
        const ObbTree tree = make_tree(make_degenerate_soup(random, count), {}, 2);
        EXPECT_TRUE(check_wide_tree(tree.view().wide, count)) << count;
    }
}

TEST_F(WideCheck, RefusesNodesThatAreNoTree) {
    expect_refused("no nodes", [](Arrays& a) { a.nodes.clear(); });
    expect_refused("a child less", [](Arrays& a) { --a.nodes[0].count; });
    expect_refused("a child more", [](Arrays& a) { ++a.nodes[0].count; });
    expect_refused("no children", [](Arrays& a) { a.nodes[0].count = 0; });
    expect_refused("too many", [](Arrays& a) { a.nodes[0].count = 17; });
    expect_refused("its own child", [](Arrays& a) { a.nodes[0].first = 0; });
    expect_refused("children elsewhere", [](Arrays& a) { ++a.nodes[0].first; });
    expect_refused("children beyond",
                   [](Arrays& a) { a.nodes[0].first = std::numeric_limits<std::uint32_t>::max(); });
    expect_refused("a flag that is neither", [](Arrays& a) {
        const std::uint8_t two = 2;
        std::memcpy(&a.nodes[0].is_leaf, &two, 1);
    });
    expect_refused("a leaf for an inner node", [](Arrays& a) { a.nodes[0].is_leaf = true; });
    expect_refused("an inner node for a leaf", [](Arrays& a) { a.first_leaf().is_leaf = false; });
    expect_refused("a node more", [](Arrays& a) { a.nodes.push_back(a.nodes.back()); });
}

TEST_F(WideCheck, RefusesFramesThatNoNodeHas) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float step : {0.0F, -1.0F, nan, infinity}) {
        expect_refused("a step", [&](Arrays& a) { a.nodes[3].steps[1] = step; });
    }
    expect_refused("the fourth step", [](Arrays& a) { a.nodes[3].steps[3] = 2; });
    for (const float entry : {2.0F, nan, -infinity}) {
        expect_refused("an entry", [&](Arrays& a) { a.nodes[3].columns[2][1] = entry; });
    }
    expect_refused("the fourth entry", [](Arrays& a) { a.nodes[3].columns[2][3] = 1; });
    expect_refused("an origin", [](Arrays& a) { a.nodes[3].origin[0] = 2 * a.extent; });
    expect_refused("no number", [](Arrays& a) { a.nodes[3].origin[0] = nan; });
    expect_refused("an extent", [](Arrays& a) { a.extent = infinity; });
}

TEST_F(WideCheck, RefusesBlocksThatDoNotHoldTheTriangles) {
    expect_refused("a leaf's block", [](Arrays& a) { ++a.first_leaf().first; });
    expect_refused("a triangle less", [](Arrays& a) { --a.first_leaf().count; });
    expect_refused("a block beyond", [](Arrays& a) {
        a.first_leaf().first = std::numeric_limits<std::uint32_t>::max();
    });
    expect_refused("a corner beyond", [](Arrays& a) { a.corners[0][2] = 255; });
    expect_refused("a fourth corner", [](Arrays& a) { a.corners[0][3] = 1; });
    expect_refused("a triangle twice", [](Arrays& a) { a.ids[1] = a.ids[0]; });
    expect_refused("a triangle beyond", [](Arrays& a) { a.ids[0] = 512; });
    expect_refused("a vertex beyond reach", [](Arrays& a) { a.reach /= 2; });
    expect_refused("a reach", [](Arrays& a) { a.reach = std::numeric_limits<double>::infinity(); });
    expect_refused("no reach", [](Arrays& a) { a.reach = std::nan(""); });
}

TEST_F(WideCheck, RefusesArraysOfOtherLengths) {
    expect_refused("numbers", [](Arrays& a) { a.doubles.pop_back(); });
    expect_refused("numbers", [](Arrays& a) { a.doubles.push_back(0); });
    expect_refused("floats as well", [](Arrays& a) { a.floats.assign(a.doubles.size(), 0); });
    expect_refused("neither", [](Arrays& a) { a.doubles.clear(); });
    expect_refused("corners", [](Arrays& a) { a.corners.pop_back(); });
    expect_refused("ids", [](Arrays& a) { a.ids.push_back(0); });
    expect_refused("no begins", [](Arrays& a) { a.vertex_begin.clear(); });
    expect_refused("a begin less", [](Arrays& a) { a.vertex_begin.pop_back(); });
    expect_refused("the first begin", [](Arrays& a) { a.vertex_begin[0] = 1; });
    expect_refused("an end before its begin", [](Arrays& a) { a.vertex_begin[1] = 1u << 31; });
    expect_refused("an empty block", [](Arrays& a) { a.vertex_begin[1] = 0; });
    expect_refused("no nodes, but triangles", [](Arrays& a) { a.nodes.clear(); });
}

} // namespace
} // namespace cd::tests
