// Proves that what is packed is unpacked by zlib to the same bytes.
#include "client/formats/gzip.hpp"

#include "tests/support/report_answers.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cd::tests {

TEST(Gzip, UnpacksToTheSameBytes) {
    std::mt19937_64 random(5);
    for (const std::size_t size : {0u, 1u, 100u, 65'535u, 65'536u, 65'537u, 1'000'000u}) {
        for (const unsigned values : {1u, 7u, 256u}) {
            Bytes bytes(size);
            for (std::byte& each : bytes) {
                each = static_cast<std::byte>(random() % values);
            }
            const Bytes packed = gzip(bytes);
            const auto unpacked = gunzip(packed);
            ASSERT_TRUE(unpacked) << size;
            EXPECT_TRUE(*unpacked == bytes) << size << " bytes of " << values << " values";
        }
    }
}

TEST(Gzip, HoldsNoTime) {
    const Bytes packed = gzip(Bytes(10));
    ASSERT_GE(packed.size(), 10u);
    for (std::size_t i = 4; i < 8; ++i) { // The field MTIME of RFC 1952.
        EXPECT_EQ(packed[i], std::byte{0});
    }
}

} // namespace cd::tests
