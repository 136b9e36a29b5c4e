// Proves that a frame decoded from a code is orthonormal and encodes to that code, and that any
// frame has a close code.

#include "common/tree/wide/wide_frame.hpp"

#include "common/tree/build/build_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace cd::tests {
namespace {

using Axes = std::array<float, 9>;

std::int16_t some_part(std::mt19937_64& random) {
    return static_cast<std::int16_t>(static_cast<int>(random() % 65535) - 32767);
}

/// Makes codes of parts that are random, tiny, or so large that the omitted part is about as large.
FrameCode some_code(std::mt19937_64& random) {
    FrameCode code;
    code.kind = static_cast<std::uint8_t>(1 + random() % 4);
    const std::uint64_t size = random() % 4;
    for (std::int16_t& part : code.parts) {
        const int sign = random() % 2 == 0 ? 1 : -1;
        const int near = static_cast<int>(random() % 7) - 3;
        part = size == 0   ? static_cast<std::int16_t>(near)
               : size == 1 ? static_cast<std::int16_t>(sign * (23170 + near))
                           : some_part(random);
    }
    if (size == 2) {
        code.parts = {static_cast<std::int16_t>(32767 - random() % 3), 0, 0};
        std::swap(code.parts[0], code.parts[random() % 3]);
    }
    return code;
}

double error_of(const Axes& axes) {
    double error = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            double dot = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) {
                dot += static_cast<double>(axes[3 * i + k]) * static_cast<double>(axes[3 * j + k]);
            }
            error = std::max(error, std::abs(dot));
        }
    }
    return error;
}

} // namespace

TEST(WideFrame, ADecodedFrameIsOrthonormalAndEncodesToItsCode) {
    std::mt19937_64 random(1);
    int frames = 0;
    for (int round = 0; round < 100'000; ++round) {
        const FrameCode code = some_code(random);
        const auto frame = frame_of(code);
        if (!frame) {
            continue;
        }
        ++frames;
        ASSERT_LE(error_of(*frame), axes_error_max) << round;
        ASSERT_EQ(frame_of(code_of(*frame)), frame) << round;
    }
    EXPECT_GT(frames, 60'000);
    EXPECT_EQ(frame_of({}), body_axes);
    EXPECT_EQ(code_of(body_axes), FrameCode{});
}

TEST(WideFrame, InvalidCodesAreRejected) {
    EXPECT_FALSE(frame_of({5, {0, 0, 0}}));
    EXPECT_FALSE(frame_of({255, {0, 0, 0}}));
    EXPECT_FALSE(frame_of({1, {32767, 32767, 0}}));
    EXPECT_FALSE(frame_of({2, {-32768, -32768, -32768}}));
}

TEST(WideFrame, IsCloseToAnyFrameOrToOneWithItsThirdRowTurnedRound) {
    std::mt19937_64 random(2);
    for (int round = 0; round < 20'000; ++round) {
        // A frame of a much finer code, half of the time mirrored.
        const FrameCode code = some_code(random);
        const auto exact = frame_of(code);
        if (!exact) {
            continue;
        }
        Axes turned = *exact;
        const double angle = 1e-3 * static_cast<double>(random() % 1000);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto x = static_cast<double>((*exact)[k]);
            const auto y = static_cast<double>((*exact)[3 + k]);
            turned[k] = static_cast<float>(std::cos(angle) * x + std::sin(angle) * y);
            turned[3 + k] = static_cast<float>(std::cos(angle) * y - std::sin(angle) * x);
        }
        const bool is_mirrored = random() % 2 == 0;
        Axes given = turned;
        for (std::size_t k = 6; k < 9; ++k) {
            given[k] = is_mirrored ? -turned[k] : turned[k];
        }
        const auto found = frame_of(code_of(given));
        ASSERT_TRUE(found) << round;
        for (std::size_t k = 0; k < 9; ++k) {
            ASSERT_NEAR((*found)[k], turned[k], 1e-4) << round;
        }
    }
}

} // namespace cd::tests
