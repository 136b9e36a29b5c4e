// Proves that decompression restores the data, and that no bytes make the reader exceed its limit,
// crash, or accept damage.
#include "common/core/files/compress.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

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

TEST(Compress, RoundTripRestoresTheData) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{200'000}}) {
        for (const int level : {compression_level_fast, compression_level_geometry}) {
            const auto back = decompress(compress(sample(size), level), size);
            ASSERT_TRUE(back.has_value()) << size;
            EXPECT_EQ(back.value(), sample(size));
        }
    }
}

TEST(Compress, RepetitiveDataShrinks) {
    EXPECT_LT(compress(sample(10'000), compression_level_fast).size(), 5'000u);
}

TEST(Compress, MoreThanTheLimitIsRefused) {
    const Bytes packed = compress(Bytes(1u << 20), compression_level_fast);
    EXPECT_EQ(error_of(packed, (1u << 20) - 1), ErrorCode::TooLarge);
    EXPECT_TRUE(decompress(packed, 1u << 20).has_value());
}

/// A thread uses its contexts of zstd again and again.
TEST(Compress, DamageDoesNotSpoilWhatTheThreadDecompressesNext) {
    const Bytes packed = compress(sample(1000), compression_level_geometry);
    Bytes damaged = packed;
    damaged[packed.size() / 2] ^= std::byte{0xff};
    for (int round = 0; round < 3; ++round) {
        (void)decompress(damaged, 1000);
        const auto back = decompress(packed, 1000);
        ASSERT_TRUE(back.has_value());
        EXPECT_EQ(back.value(), sample(1000));
        EXPECT_EQ(compress(sample(1000), compression_level_geometry), packed);
    }
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

TEST(Compress, AClaimedSizeAllocatesNothing) {
    // A frame that claims a GiB but has one block, of one byte.
    Bytes lie = compress(Bytes(std::size_t{1} << 30), compression_level_fast);
    const Bytes little = compress(Bytes(1), compression_level_fast);
    // Magic number, descriptor, window and a size of 4 bytes; or no window and a size of 1 byte.
    ASSERT_EQ(std::to_integer<int>(lie[4]), 0x80);
    ASSERT_EQ(std::to_integer<int>(little[4]), 0x20);
    lie.resize(10);
    lie.insert(lie.end(), little.begin() + 6, little.end());
    const auto peak = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const long before = peak();
    EXPECT_EQ(error_of(lie, std::size_t{1} << 30), ErrorCode::BadFrame);
    EXPECT_LT(peak() - before, 256 * 1024) << "KiB";
}

TEST(Compress, HighlyCompressibleDataRoundTrips) {
    const Bytes nothing(10'000'000);
    const Bytes packed = compress(nothing, compression_level_geometry);
    ASSERT_LT(packed.size(), nothing.size() / 1000);
    EXPECT_EQ(decompress(packed, nothing.size()).value(), nothing);
}

} // namespace cd::tests
