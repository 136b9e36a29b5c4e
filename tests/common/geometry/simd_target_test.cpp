// Proves that a SIMD target can be forced and reset, and that a wrong name changes nothing.
#include "common/geometry/simd_target.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

/// Resets the target when a test ends.
class SimdTargets : public testing::Test {
  protected:
    void TearDown() override { ASSERT_TRUE(force_simd_target("auto")); }
};

} // namespace

TEST_F(SimdTargets, EachAvailableOneCanBeForced) {
    const auto available = available_simd_targets();
    ASSERT_FALSE(available.empty());
    EXPECT_TRUE(std::is_sorted(available.begin(), available.end()));
    for (const SimdTarget target : available) {
        ASSERT_TRUE(force_simd_target(to_text(target)));
        EXPECT_EQ(simd_target(), target);
    }
}

TEST_F(SimdTargets, AutoIsTheBest) {
    ASSERT_TRUE(force_simd_target(to_text(available_simd_targets().back())));
    ASSERT_TRUE(force_simd_target("auto"));
    EXPECT_EQ(simd_target(), available_simd_targets().front());
}

TEST_F(SimdTargets, AnUnknownNameIsAnErrorThatNamesTheOthers) {
    const auto before = simd_target();
    const auto status = force_simd_target("mmx");

    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::BadInput);
    for (const SimdTarget target : available_simd_targets()) {
        EXPECT_NE(status.error().detail.find(to_text(target)), std::string::npos);
    }
    EXPECT_EQ(simd_target(), before);
}

} // namespace cd::tests
