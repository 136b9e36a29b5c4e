// Proves that blocks return every corner exactly, in either precision, and store shared corners
// once.
#include "common/geometry/triangle_blocks.hpp"

#include <gtest/gtest.h>

namespace cd::tests {

namespace {

const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1.5, -2}};
const std::vector<Triangle> halves = {{0, 1, 2}, {0, 2, 3}};

} // namespace

class TriangleBlocksTest : public testing::TestWithParam<Precision> {};

INSTANTIATE_TEST_SUITE_P(Precisions,
                         TriangleBlocksTest,
                         testing::Values(Precision::Float, Precision::Double));

TEST_P(TriangleBlocksTest, CornersComeBackAsTheyWere) {
    TriangleBlockArrays arrays(GetParam());
    const std::vector<std::uint32_t> ids = {7, 3};
    EXPECT_EQ(arrays.add(halves, ids, square), 0u);
    EXPECT_EQ(arrays.add(std::span(halves).last(1), std::span(ids).last(1), square), 1u);
    const TriangleBlocks blocks = arrays.view();
    for (std::uint32_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(blocks.corners_at(i)[k], square[halves[i][k]]);
            EXPECT_EQ(blocks.corners_at(block_size)[k], square[halves[1][k]]);
        }
    }
    EXPECT_EQ(blocks.ids[0], 7u);
    EXPECT_EQ(blocks.ids[1], 3u);
    EXPECT_EQ(blocks.ids[block_size], 3u);
    EXPECT_EQ(blocks.reach, 2);
}

TEST_P(TriangleBlocksTest, ASharedCornerIsHeldOnce) {
    TriangleBlockArrays arrays(GetParam());
    arrays.add(halves, std::vector<std::uint32_t>{0, 1}, square);
    const TriangleBlocks blocks = arrays.view();
    EXPECT_EQ(blocks.vertex_begin[1], square.size());
}

} // namespace cd::tests
