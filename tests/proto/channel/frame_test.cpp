// Proves that frames carry messages whole, in pieces and interleaved, and that a damaged, hostile
// or endless stream of frames ends in an error with bounded memory.
#include "proto/channel/frame.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/limits/wire.hpp"
#include "proto/codec/codec.hpp"
#include "tests/proto/sample_messages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <string_view>
#include <vector>

namespace cd::tests {
namespace {

FrameHeader header_of(std::uint16_t type, std::span<const std::byte> payload) {
    FrameHeader header;
    header.type = type;
    header.payload_bytes = static_cast<std::uint32_t>(payload.size());
    header.payload_checksum = checksum(payload);
    return header;
}

using HeaderBytes = std::array<std::byte, frame_header_bytes>;

/// Returns the header with a value changed and the checksum corrected.
HeaderBytes
forged(const FrameHeader& header, std::size_t place, std::uint32_t value, std::size_t n) {
    HeaderBytes bytes = encode_header(header);
    std::memcpy(bytes.data() + place, &value, n);
    const auto sum = static_cast<std::uint32_t>(checksum(std::span(bytes).first(28)));
    std::memcpy(bytes.data() + 28, &sum, sizeof sum);
    return bytes;
}

TEST(Frame, HeadersComeBackAsTheyWere) {
    FrameHeader header = header_of(8, some_bytes(20));
    header.has_more = true;
    header.stream = 7;
    header.epoch = 9;
    const auto decoded = decode_header(encode_header(header));
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded.value(), header);
}

TEST(Frame, TheHeaderIsThatOfVersionOne) {
    FrameHeader header = header_of(8, some_bytes(20));
    header.has_more = true;
    header.stream = 1;
    const HeaderBytes bytes = encode_header(header);
    EXPECT_EQ(std::memcmp(bytes.data(), "CDF1", 4), 0);
    EXPECT_EQ(to_short_hex(sha256(bytes)), "bffbbfc6efc456a6");
}

TEST(Frame, AnyChangedBitOfAHeaderIsRefused) {
    const HeaderBytes good = encode_header(header_of(8, some_bytes(20)));
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
        HeaderBytes bytes = good;
        bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
        EXPECT_FALSE(decode_header(bytes)) << bit;
    }
}

TEST(Frame, ForgedHeadersAreRefused) {
    const FrameHeader header = header_of(8, some_bytes(20));
    EXPECT_TRUE(decode_header(forged(header, 4, 8, 2)));
    EXPECT_FALSE(decode_header(forged(header, 4, 0, 2))) << "type 0";
    EXPECT_FALSE(decode_header(forged(header, 4, 999, 2))) << "unknown type";
    EXPECT_FALSE(decode_header(forged(header, 6, 2, 2))) << "unknown flag";
    const auto overlong = decode_header(forged(header, 12, limits::frame_payload_bytes_max + 1, 4));
    ASSERT_FALSE(overlong);
    EXPECT_EQ(overlong.error().code, ErrorCode::TooLarge);
}

TEST(MessageAssembler, PutsMessagesOfTwoStreamsTogether) {
    MessageAssembler assembler;
    const Bytes left = some_bytes(100);
    const Bytes right = some_bytes(50, 7);
    const auto add = [&](std::uint32_t stream,
                         std::uint16_t type,
                         std::span<const std::byte> piece,
                         bool has_more) {
        FrameHeader header = header_of(type, piece);
        header.stream = stream;
        header.has_more = has_more;
        return assembler.add(header, piece);
    };
    EXPECT_FALSE(add(1, 7, std::span(left).first(60), true).value());
    EXPECT_FALSE(add(0, 11, std::span(right).first(20), true).value());
    const auto second = add(0, 11, std::span(right).subspan(20), false);
    ASSERT_TRUE(second.value());
    EXPECT_EQ(second.value()->type, 11);
    EXPECT_EQ(second.value()->payload, right);
    const auto first = add(1, 7, std::span(left).subspan(60), false);
    ASSERT_TRUE(first.value());
    EXPECT_EQ(first.value()->payload, left);
    EXPECT_TRUE(add(1, 9, {}, false).value()) << "an empty message is a message";
}

TEST(MessageAssembler, ADamagedPayloadIsRefused) {
    MessageAssembler assembler;
    Bytes payload = some_bytes(100);
    const FrameHeader header = header_of(7, payload);
    payload[50] ^= std::byte{1};
    EXPECT_FALSE(assembler.add(header, payload));
    EXPECT_FALSE(MessageAssembler().add(header, std::span(payload).first(99)));
}

TEST(MessageAssembler, AMessageThatNeverEndsIsRefusedAtItsTypesLimit) {
    MessageAssembler assembler;
    const Bytes piece(limits::frame_payload_bytes_max);
    FrameHeader header = header_of(message_type(Heartbeat{}), piece);
    header.has_more = true;
    ASSERT_TRUE(assembler.add(header, piece));
    const auto over = assembler.add(header, piece);
    ASSERT_FALSE(over);
    EXPECT_EQ(over.error().code, ErrorCode::TooLarge);
}

TEST(MessageAssembler, TooManyMessagesBegunAndEmptyPiecesAreRefused) {
    MessageAssembler assembler;
    const Bytes piece = some_bytes(1);
    FrameHeader header = header_of(7, piece);
    header.has_more = true;
    for (header.stream = 0; header.stream < limits::streams_max; ++header.stream) {
        EXPECT_TRUE(assembler.add(header, piece));
    }
    EXPECT_FALSE(assembler.add(header, piece));

    FrameHeader empty = header_of(7, {});
    empty.has_more = true;
    EXPECT_FALSE(MessageAssembler().add(empty, {}));
}

TEST(MessageAssembler, AMessageMayNotChangeItsType) {
    MessageAssembler assembler;
    const Bytes piece = some_bytes(4);
    FrameHeader header = header_of(7, piece);
    header.has_more = true;
    ASSERT_TRUE(assembler.add(header, piece));
    header.type = 8;
    EXPECT_FALSE(assembler.add(header, piece));
}

// ---- Permitted senders ----------------------------------------------------------------------

constexpr std::array<Party, 8> parties{Party::Stranger,
                                       Party::Joiner,
                                       Party::Observer,
                                       Party::Client,
                                       Party::Worker,
                                       Party::Peer,
                                       Party::Giver,
                                       Party::Master};

template <class... Types>
std::vector<std::uint16_t> types_of() {
    return {message_type(Types{})...};
}

std::vector<std::uint16_t> types_from(Party party) {
    std::vector<std::uint16_t> types;
    for (std::uint16_t type = 0; type <= std::variant_size_v<Message> + 1; ++type) {
        if (payload_bytes_max_from(party, type) != 0) {
            types.push_back(type);
        }
    }
    return types;
}

/// Returns the memory bound for incomplete messages.
std::uint64_t begun_bytes_max(Party party) {
    std::uint64_t largest = 0;
    for (const std::uint16_t type : types_from(party)) {
        largest = std::max(largest, payload_bytes_max_from(party, type));
    }
    return largest * streams_max_of(party);
}

TEST(Party, EachSendsWhatTheProtocolSays) {
    EXPECT_EQ(types_from(Party::Stranger), (types_of<Hello, Welcome, Failure>()));
    EXPECT_EQ(types_from(Party::Joiner), (types_of<Failure, Join, Renew>()));
    EXPECT_EQ(types_from(Party::Peer), (types_of<Failure, PeerFetch>()));
    EXPECT_EQ(types_from(Party::Giver), (types_of<Failure, Subtrees, PeerFetched>()));
    EXPECT_EQ(types_from(Party::Worker),
              (types_of<Failure,
                        Heartbeat,
                        Drain,
                        WantSubtrees,
                        Results,
                        EndOfTask,
                        Evicted,
                        Held,
                        FetchFailed,
                        Holding,
                        Inventory,
                        Recalled>()));
    EXPECT_EQ(types_from(Party::Client),
              (types_of<Failure,
                        Heartbeat,
                        MeshesQuery,
                        MeshPart,
                        Submit,
                        PosesPart,
                        PosesEnd,
                        Watch,
                        StatusQuery,
                        ResultsQuery,
                        Cancel,
                        Explain,
                        TokenCreate,
                        ContactMapQuery,
                        JobQuery,
                        MeshQuery,
                        PosesQuery,
                        Remove,
                        RemoveMesh,
                        DrainWorkers,
                        SetPriority>()));
    EXPECT_EQ(types_from(Party::Observer), types_from(Party::Client));
    for (std::uint16_t type = 1; type <= std::variant_size_v<Message>; ++type) {
        EXPECT_TRUE(std::any_of(parties.begin(), parties.end(), [&](Party party) {
            return payload_bytes_max_from(party, type) != 0;
        })) << message_name(type);
        EXPECT_EQ(payload_bytes_max_from(Party::Anyone, type), payload_bytes_max(type));
    }
}

TEST(Party, TheLessItIsKnownTheLessMemoryIsTakenForIt) {
    EXPECT_EQ(begun_bytes_max(Party::Stranger), 4u << 10);
    EXPECT_EQ(begun_bytes_max(Party::Observer), 4u << 10);
    EXPECT_EQ(begun_bytes_max(Party::Joiner), 64u << 10);
    EXPECT_EQ(begun_bytes_max(Party::Peer), 16u << 20);
    EXPECT_EQ(begun_bytes_max(Party::Client), 32u << 20);
    EXPECT_EQ(begun_bytes_max(Party::Worker), 514u << 20);
}

TEST(MessageAssembler, WhatItsSenderDoesNotSendIsRefusedByItsHeader) {
    FrameHeader header;
    header.type = message_type(Subtrees{});
    header.payload_bytes = limits::frame_payload_bytes_max;
    header.has_more = true;
    for (const Party party : parties) {
        MessageAssembler assembler;
        assembler.expect(party);
        const bool sends_it = party == Party::Master || party == Party::Giver;
        EXPECT_EQ(assembler.check(header).has_value(), sends_it) << to_text(party);
    }
}

TEST(MessageAssembler, WhatIsTooLargeIsRefusedByItsHeader) {
    MessageAssembler stranger;
    stranger.expect(Party::Stranger);
    const Bytes piece(4u << 10);
    FrameHeader header = header_of(message_type(Hello{}), piece);
    header.has_more = true;
    EXPECT_TRUE(stranger.check(header));
    FrameHeader over = header;
    over.payload_bytes += 1;
    EXPECT_EQ(stranger.check(over).error().code, ErrorCode::TooLarge);
    // The incomplete message counts, and the stranger may not begin a second one.
    ASSERT_TRUE(stranger.add(header, piece));
    FrameHeader next = header;
    next.payload_bytes = 1;
    EXPECT_EQ(stranger.check(next).error().code, ErrorCode::TooLarge);
    next.stream = 1;
    EXPECT_EQ(stranger.check(next).error().code, ErrorCode::TooLarge);
}

TEST(Frame, AWebServersAnswerIsRecognised) {
    const std::string_view answer = "HTTP/1.1 400 Bad Request\r\nServer: cdmaster\r\n";
    std::array<std::byte, frame_header_bytes> bytes{};
    std::memcpy(bytes.data(), answer.data(), bytes.size());
    const auto decoded = decode_header(bytes);
    ASSERT_FALSE(decoded);
    EXPECT_EQ(decoded.error().code, ErrorCode::BadFrame);
    EXPECT_NE(decoded.error().detail.find("that is the master's --http port"), std::string::npos);
}

TEST(Frame, AnAlertOfTlsIsRecognisedBeforeAHeaderIsWhole) {
    const std::array<std::byte, 7> alert{
        std::byte{0x15}, std::byte{3}, std::byte{3}, std::byte{0}, std::byte{2}, std::byte{2}};
    const auto foreign = foreign_answer(alert);
    ASSERT_TRUE(foreign);
    EXPECT_EQ(foreign->code, ErrorCode::Refused);
    EXPECT_TRUE(foreign->detail.starts_with("the master speaks TLS: cdctl join"));
    EXPECT_FALSE(foreign_answer(std::span(alert).first(1)));
    EXPECT_FALSE(foreign_answer(encode_header({})));
}

} // namespace
} // namespace cd::tests
