// Proves that the build keeps explicit roundings: a compiler that drops the one of double(float(x))
// would make meshes that are not the floats they claim to be.
#include <gtest/gtest.h>

#include <array>

namespace cd::tests {

namespace {

[[gnu::noinline]] void narrow(double* values) {
    for (int i = 0; i < 2; ++i) {
        values[i] = static_cast<double>(static_cast<float>(values[i]));
    }
}

} // namespace

TEST(Rounding, FloatRoundingIsNotOptimisedAway) {
    std::array<double, 2> values{0.1, 0.2};
    narrow(values.data());
    const volatile float first = 0.1f;
    const volatile float second = 0.2f;
    EXPECT_EQ(values[0], static_cast<double>(first));
    EXPECT_EQ(values[1], static_cast<double>(second));
}

} // namespace cd::tests
