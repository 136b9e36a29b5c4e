// Proves that the cost of a search is the paper's sum over the counted tests, and that its
// constants are measured if there is data. Checks no times.
#include "common/search/search_cost.hpp"

#include "common/tree/query_statistics.hpp"
#include "tests/support/trees.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {

namespace {

ObbTree torus_tree() {
    return make_tree(make_torus(1.0, 0.4, 24, 12));
}

/// Makes poses of B along x; the nearer, the more contacts.
std::vector<PosePair> moved_along_x(double from, double to) {
    std::vector<PosePair> poses;
    for (int i = 0; i < 5; ++i) {
        poses.push_back(
            {Pose{},
             Pose::from_quaternion({1, 0.2, 0.1, 0}, Vec3(from + 0.25 * i * (to - from), 0, 0))});
    }
    return poses;
}

} // namespace

TEST(SearchCost, IsTheSumOverBothKindsOfTests) {
    QueryStatistics statistics;
    statistics.box_tests = 1'000'000;
    statistics.triangle_tests = 3'000;
    const SearchCost cost{2, 500};
    EXPECT_DOUBLE_EQ(cost.seconds_of(statistics), 0.0035);
}

TEST(SearchCost, IsMeasuredWhereTrianglesAreTested) {
    const ObbTree tree = torus_tree();
    for (const bool for_any : {false, true}) {
        SearchCostOptions options;
        options.for_any = for_any;
        const auto cost =
            measure_search_cost(tree.view(), tree.view(), moved_along_x(0.2, 2.0), options);
        ASSERT_TRUE(cost);
        EXPECT_TRUE(std::isfinite(cost->box_test_ns));
        EXPECT_TRUE(std::isfinite(cost->triangle_test_ns));
        EXPECT_GE(cost->box_test_ns, 0);
        EXPECT_GE(cost->triangle_test_ns, 0);
    }
}

TEST(SearchCost, IsUnknownWhereNoTriangleIsTested) {
    const ObbTree tree = torus_tree();
    EXPECT_FALSE(measure_search_cost(tree.view(), tree.view(), moved_along_x(50, 60)));
    EXPECT_FALSE(measure_search_cost(tree.view(), tree.view(), {}));
    EXPECT_FALSE(measure_search_cost(forms_of(tree)[1], tree.view(), moved_along_x(0.2, 2.0)));
}

} // namespace cd::tests
