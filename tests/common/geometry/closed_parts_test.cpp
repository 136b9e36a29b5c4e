// Proves that a part is closed by its own triangles alone, wherever they stand in the mesh.
#include "common/geometry/closed_parts.hpp"

#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace cd::tests {

namespace {

using testing::ElementsAre;

constexpr std::uint32_t box_triangles = 12;

/// Returns two boxes, and a plate of two triangles.
Mesh boxes_and_plate() {
    return join({make_box({1, 1, 1}),
                 translated(make_box({1, 1, 1}), {3, 0, 0}),
                 make_mesh({Vec3(9, 0, 0), Vec3(9, 1, 0), Vec3(9, 1, 1), Vec3(9, 0, 1)},
                           {{0, 1, 2}, {0, 2, 3}})});
}

std::vector<bool> closed(std::vector<PartRun> runs) {
    return closed_parts(boxes_and_plate(), PartRuns::create(std::move(runs)).value());
}

} // namespace

TEST(ClosedParts, BoxesAreClosedAndAPlateIsNot) {
    EXPECT_THAT(closed({{0, 0}, {box_triangles, 1}, {2 * box_triangles, 2}}),
                ElementsAre(true, true, false));
    EXPECT_THAT(closed({{0, 0}, {box_triangles, 1}}), ElementsAre(true, false));
}

TEST(ClosedParts, APartMayHaveSeveralRuns) {
    EXPECT_THAT(closed({{0, 0}, {5, 1}, {box_triangles, 2}, {2 * box_triangles, 1}}),
                ElementsAre(false, false, true))
        << "each half of a box is open";
    EXPECT_THAT(closed({{0, 1}, {box_triangles, 0}, {2 * box_triangles, 2}}),
                ElementsAre(true, true, false));
    EXPECT_THAT(closed({{0, 1}, {5, 1}, {box_triangles, 0}}), ElementsAre(false, true));
}

TEST(ClosedParts, APartWithoutTrianglesIsNotClosed) {
    EXPECT_THAT(closed({{0, 1}, {2 * box_triangles, 2}}), ElementsAre(false, true, false));
}

} // namespace cd::tests
