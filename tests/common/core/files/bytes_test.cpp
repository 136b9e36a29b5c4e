// Proves that the reader returns what the writer wrote, that bytes are little-endian, and that
// truncated bytes or false counts fail without a large allocation.
#include "common/core/files/bytes.hpp"

#include "common/core/varint.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace cd::tests {

namespace {

Bytes make_bytes(std::initializer_list<unsigned> values) {
    Bytes bytes;
    for (const unsigned value : values) {
        bytes.push_back(static_cast<std::byte>(value));
    }
    return bytes;
}

} // namespace

TEST(Bytes, ComeBackAsTheyWerePut) {
    ByteWriter out;
    out.put(std::uint8_t{200});
    out.put(-2.5);
    out.put_text("hull\0x");
    out.put_array(std::span<const std::uint32_t>(std::array<std::uint32_t, 2>{1, 4'000'000'000}));
    out.put_array(std::span<const double>());

    ByteReader in(out.bytes());
    EXPECT_EQ(in.get<std::uint8_t>(), 200);
    EXPECT_EQ(in.get<double>(), -2.5);
    EXPECT_EQ(in.get_text(), "hull\0x");
    EXPECT_EQ(in.get_array<std::uint32_t>(2), (std::vector<std::uint32_t>{1, 4'000'000'000}));
    EXPECT_TRUE(in.complete());
}

TEST(Bytes, AreLittleEndian) {
    ByteWriter out;
    out.put(std::uint32_t{0x01020304});
    EXPECT_EQ(out.bytes(), make_bytes({4, 3, 2, 1}));
}

TEST(Bytes, AReaderThatFailedGivesZerosAndStaysFailed) {
    const Bytes bytes = make_bytes({1, 2, 3});
    ByteReader in(bytes);
    EXPECT_EQ(in.get<std::uint32_t>(), 0u);
    EXPECT_TRUE(in.failed());
    EXPECT_EQ(in.get<std::uint8_t>(), 0); // Although a byte is left.
    EXPECT_TRUE(in.get_array<std::uint8_t>(1).empty());
    EXPECT_EQ(in.get_text(), "");
    EXPECT_FALSE(in.complete());
}

TEST(Bytes, BytesLeftOverAreNotComplete) {
    const Bytes bytes = make_bytes({1, 2});
    ByteReader in(bytes);
    static_cast<void>(in.get<std::uint8_t>());
    EXPECT_FALSE(in.failed());
    EXPECT_FALSE(in.complete());
    EXPECT_EQ(in.remaining(), 1u);
}

TEST(Bytes, ACountThatLiesFailsBeforeAnyAllocation) {
    const Bytes bytes(64);
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    // The second count, times the size of a double, wraps around to 8.
    for (const std::uint64_t count : {most, most / 8 + 2, std::uint64_t{9}}) {
        ByteReader in(bytes);
        EXPECT_TRUE(in.get_array<double>(count).empty());
        EXPECT_TRUE(in.failed());
    }
    ByteReader in(bytes);
    EXPECT_EQ(in.get_array<double>(8).size(), 8u);
    EXPECT_TRUE(in.complete());
}

TEST(Varint, ComesBackInItsShortestForm) {
    const std::vector<std::pair<std::uint64_t, std::size_t>> sizes{
        {0, 1}, {127, 1}, {128, 2}, {16'383, 2}, {16'384, 3}, {~std::uint64_t{0}, 10}};
    for (const auto& [value, size] : sizes) {
        ByteWriter out;
        put_varint(out, value);
        EXPECT_EQ(out.size(), size);
        ByteReader in(out.bytes());
        EXPECT_EQ(get_varint(in), value);
        EXPECT_TRUE(in.complete());
    }
}

TEST(Varint, WhatIsCutShortOverlongOrTooLargeIsRefused) {
    for (const Bytes& bytes :
         {make_bytes({}),
          make_bytes({0x80}),
          make_bytes({0x80, 0x00}),
          make_bytes({0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x02}),
          make_bytes({0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x80, 0x01})}) {
        ByteReader in(bytes);
        EXPECT_EQ(get_varint(in), std::nullopt) << bytes.size();
    }
}

TEST(Varint, ZigzagKeepsSmallMagnitudesSmall) {
    constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();
    EXPECT_EQ(zigzag(0), 0u);
    EXPECT_EQ(zigzag(-1), 1u);
    EXPECT_EQ(zigzag(1), 2u);
    for (const std::int64_t value : {lowest, lowest + 1, std::int64_t{-77}, highest}) {
        EXPECT_EQ(unzigzag(zigzag(value)), value);
    }
}

} // namespace cd::tests
