// Proves that the side of a line is exact where doubles cannot decide it.
#include "common/pair/numbers/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cd::tests {
namespace {

TEST(Orientation, TellsLeftFromRight) {
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), -1);
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {2, 2}), 0);
}

TEST(Orientation, SeesOneRoundingStepOffALine) {
    const double third = 12.1;
    const double up = std::nextafter(third, 13.0);
    EXPECT_EQ(orientation({0.5, 0.5}, {12.1, 12.1}, {24.3, 24.3}), 0);
    EXPECT_EQ(orientation({0.5, 0.5}, {12.1, up}, {24.3, 24.3}), -1);
    EXPECT_EQ(orientation({0.5, 0.5}, {up, 12.1}, {24.3, 24.3}), 1);
}

TEST(Orientation, IsExactAtTheEndsOfTheRange) {
    EXPECT_EQ(orientation({0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}), 1);
    EXPECT_EQ(orientation({0, 0}, {0x1p-600, 0x1p-600}, {0x1p-599, 0x1p-599}), 0);
}

} // namespace
} // namespace cd::tests
