// Proves that what was compressed comes back, and that no bytes make the reader exceed its limit,
// crash, or take damage for data.
#include "common/core/compress.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cd::tests {

namespace {

Bytes sample(std::size_t size) {
    std::mt19937_64 random(size);
    Bytes bytes(size);
    for (std::byte& byte : bytes) {
        byte = static_cast<std::byte>(random() % 7);
    }
    return bytes;
}

ErrorCode error_of(std::span<const std::byte> bytes, std::size_t size_max) {
    const auto result = decompress(bytes, size_max);
    return result ? ErrorCode::Interrupted : result.error().code;
}

} // namespace

TEST(Compress, ComesBack) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{200'000}}) {
        for (const int level : {compression_level_fast, compression_level_geometry}) {
            const auto back = decompress(compress(sample(size), level), size);
            ASSERT_TRUE(back.has_value()) << size;
            EXPECT_EQ(back.value(), sample(size));
        }
    }
}

TEST(Compress, IsSmallerWhereThereIsLittleToSay) {
    EXPECT_LT(compress(sample(10'000), compression_level_fast).size(), 5'000u);
}

TEST(Compress, MoreThanTheLimitIsRefused) {
    const Bytes packed = compress(Bytes(1u << 20), compression_level_fast);
    EXPECT_EQ(error_of(packed, (1u << 20) - 1), ErrorCode::TooLarge);
    EXPECT_TRUE(decompress(packed, 1u << 20).has_value());
}

TEST(Compress, BytesThatAreNotOneFrameAreRefused) {
    Bytes packed = compress(sample(1000), compression_level_fast);
    for (std::size_t size = 0; size < packed.size(); ++size) {
        EXPECT_EQ(error_of(std::span(packed).first(size), 1000), ErrorCode::BadFrame) << size;
    }
    const Bytes frame = packed;
    packed.push_back(std::byte{0});
    EXPECT_EQ(error_of(packed, 1000), ErrorCode::BadFrame);
    packed.pop_back();
    packed.insert(packed.end(), frame.begin(), frame.end());
    EXPECT_EQ(error_of(packed, 10'000), ErrorCode::BadFrame);
    EXPECT_EQ(error_of(sample(100), 10'000), ErrorCode::BadFrame);
}

TEST(Compress, DamageStaysWithinTheLimit) {
    const Bytes packed = compress(sample(1000), compression_level_fast);
    for (std::size_t bit = 0; bit < 8 * packed.size(); ++bit) {
        Bytes damaged = packed;
        damaged[bit / 8] ^= std::byte{static_cast<unsigned char>(1u << bit % 8)};
        const auto result = decompress(damaged, 1000);
        if (result) {
            EXPECT_LE(result.value().size(), 1000u) << bit;
        }
    }
}

} // namespace cd::tests
