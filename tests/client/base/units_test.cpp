// Proves that factors between units are exact ratios, rounded once.

#include "client/base/units.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace cd::tests {

TEST(Units, RatiosAreRoundedOnce) {
    EXPECT_EQ(unit_factor("mm", "m"), 0.001);
    EXPECT_EQ(unit_factor("m", "mm"), 1000.0);
    EXPECT_EQ(unit_factor("ft", "in"), 12.0);
    EXPECT_EQ(unit_factor("in", "mm"), 25.4);
    EXPECT_EQ(unit_factor("km", "km"), 1.0);
    EXPECT_EQ(unit_factor("inch", "m"), std::nullopt);
}

} // namespace cd::tests
