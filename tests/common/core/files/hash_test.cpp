// Proves that hashes have their published values, in one piece or in many, and that only an exact
// text form is parsed.
#include "common/core/files/hash.hpp"

#include "common/core/files/bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// FIPS 180-2, appendix B.1.
constexpr std::string_view hash_of_abc =
    "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

} // namespace

TEST(Hash, IsSha256) {
    EXPECT_EQ(to_hex(sha256(bytes_of("abc"))), hash_of_abc);
    EXPECT_EQ(to_hex(sha256({})),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(to_short_hex(sha256(bytes_of("abc"))), "ba7816bf8f01cfea");
}

TEST(Hash, IsTheSameInPieces) {
    Sha256Stream stream;
    stream.update(bytes_of("a"));
    stream.update({});
    stream.update(bytes_of("bc"));
    EXPECT_EQ(to_hex(stream.finish()), hash_of_abc);
}

TEST(Hash, HmacHasItsPublishedValues) {
    // RFC 4231, cases 1 and 2: a short key counts as one padded with zeros.
    const auto mac = [](std::string_view key, std::string_view text) {
        Sha256 padded{};
        std::ranges::copy(bytes_of(key), padded.bytes.begin());
        return to_hex(hmac_sha256(padded, bytes_of(text)));
    };
    for (int round = 0; round < 2; ++round) {
        EXPECT_EQ(mac(std::string(20, '\x0b'), "Hi There"),
                  "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
        EXPECT_EQ(mac("Jefe", "what do ya want for nothing?"),
                  "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
    }
}

TEST(Hash, TextComesBackAsTheHash) {
    const Sha256 hash = sha256(bytes_of("abc"));
    EXPECT_EQ(sha256_from_hex(to_hex(hash)), hash);
}

TEST(Hash, OtherTextIsNoHash) {
    const std::string hex(hash_of_abc);
    EXPECT_FALSE(sha256_from_hex(""));
    EXPECT_FALSE(sha256_from_hex(hex.substr(1)));
    EXPECT_FALSE(sha256_from_hex(hex + "0"));
    EXPECT_FALSE(sha256_from_hex("g" + hex.substr(1)));
    EXPECT_FALSE(sha256_from_hex(" " + hex.substr(1)));
    EXPECT_FALSE(sha256_from_hex(std::string(1, '\0') + hex.substr(1)));
}

TEST(Hash, ChecksumSeesEveryFlippedBit) {
    Bytes bytes(100, std::byte{7});
    const std::uint64_t expected = checksum(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        const std::byte mask{static_cast<unsigned char>(1u << bit % 8)};
        bytes[bit / 8] ^= mask;
        EXPECT_NE(checksum(bytes), expected) << bit;
        bytes[bit / 8] ^= mask;
    }
    EXPECT_EQ(checksum(bytes), expected);
}

} // namespace cd::tests
