// Damaged copies of bytes for tests of decoders.
#pragma once

#include "common/core/files/bytes.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <span>

namespace cd::tests {

/// Expects that `decode` refuses every prefix of these bytes, and them with a byte more.
template <class Decode>
void expect_no_other_length(Bytes bytes, const Decode& decode) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_FALSE(decode(std::span<const std::byte>(bytes).first(size))) << size << " bytes";
    }
    bytes.push_back(std::byte{0});
    EXPECT_FALSE(decode(std::span<const std::byte>(bytes)));
}

/// Flips one to three bits in the bytes from `begin` to before `end`.
inline void flip_bits(std::mt19937_64& random, Bytes& bytes, std::size_t begin, std::size_t end) {
    for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
        bytes[begin + random() % (end - begin)] ^= static_cast<std::byte>(1u << (random() % 8));
    }
}

} // namespace cd::tests
