// Proves that predicted costs grow with the amount of overlap, and are never 0.
#include "master/dispatch/cost_model.hpp"

#include "common/core/host/thread_pool.hpp"
#include "common/tree/build/build.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace cd::tests {
namespace {

TEST(CostModel, APairCountsByItsSmallerSubtree) {
    ThreadPool pool(1);
    const auto fine = std::make_shared<const Mesh>(make_sphere(3));
    const auto coarse = std::make_shared<const Mesh>(make_sphere(1));
    const TreeTop a = cut_tree(build_tree(fine, {}, pool), 0);
    const TreeTop b = cut_tree(build_tree(coarse, {}, pool), 0);
    const std::vector<RootPair> pairs = {{0, 0}};
    EXPECT_DOUBLE_EQ(meeting_size(a, b, pairs), std::sqrt(b.triangles_under(0)));
    EXPECT_DOUBLE_EQ(meeting_size(b, a, pairs), std::sqrt(b.triangles_under(0)));
    EXPECT_EQ(meeting_size(a, b, {}), 0);
}

TEST(CostModel, MoreThatMeetsTakesLongerAndNothingIsFree) {
    EXPECT_GT(predicted_ns(0), 0u);
    EXPECT_GT(predicted_ns(100), predicted_ns(10));
}

} // namespace
} // namespace cd::tests
