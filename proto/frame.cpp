#include "proto/frame.hpp"

#include "common/core/hash.hpp"
#include "common/core/limits.hpp"
#include "proto/codec.hpp"

#include <algorithm>

namespace cd {
namespace {

constexpr std::uint32_t frame_magic = 0x31464443; // "CDF1"
constexpr std::uint16_t flag_has_more = 1;
constexpr std::size_t header_checked_bytes = frame_header_bytes - sizeof(std::uint32_t);

std::uint32_t header_checksum(std::span<const std::byte> bytes) {
    return static_cast<std::uint32_t>(checksum(bytes.first(header_checked_bytes)));
}

} // namespace

std::array<std::byte, frame_header_bytes> encode_header(const FrameHeader& header) {
    ByteWriter out;
    out.put(frame_magic);
    out.put(header.type);
    out.put(static_cast<std::uint16_t>(header.has_more ? flag_has_more : 0));
    out.put(header.stream);
    out.put(header.payload_bytes);
    out.put(header.epoch);
    out.put(header.payload_checksum);
    out.put(header_checksum(out.bytes()));

    std::array<std::byte, frame_header_bytes> bytes{};
    std::copy(out.bytes().begin(), out.bytes().end(), bytes.begin());
    return bytes;
}

Result<FrameHeader> decode_header(std::span<const std::byte, frame_header_bytes> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint32_t>() != frame_magic) {
        return Error{ErrorCode::BadFrame, "no frame of this protocol: wrong magic number"};
    }
    FrameHeader header;
    header.type = in.get<std::uint16_t>();
    const auto flags = in.get<std::uint16_t>();
    header.has_more = (flags & flag_has_more) != 0;
    header.stream = in.get<std::uint32_t>();
    header.payload_bytes = in.get<std::uint32_t>();
    header.epoch = in.get<std::uint32_t>();
    header.payload_checksum = in.get<std::uint64_t>();
    if (in.get<std::uint32_t>() != header_checksum(bytes)) {
        return Error{ErrorCode::BadFrame, "damaged frame header"};
    }
    if ((flags & ~flag_has_more) != 0) {
        return Error{ErrorCode::BadFrame, "unknown frame flags " + std::to_string(flags)};
    }
    if (payload_bytes_max(header.type) == 0) {
        return Error{ErrorCode::BadFrame, "unknown message " + std::to_string(header.type)};
    }
    if (header.payload_bytes > frame_payload_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "frame of " + std::to_string(header.payload_bytes) + " bytes"};
    }
    return header;
}

Result<std::optional<MessageAssembler::Whole>>
MessageAssembler::add(const FrameHeader& header, std::span<const std::byte> payload) {
    if (payload.size() != header.payload_bytes || checksum(payload) != header.payload_checksum) {
        return Error{ErrorCode::BadFrame, "damaged frame payload"};
    }
    // Otherwise a peer could send frames for ever without getting anywhere.
    if (header.has_more && payload.empty()) {
        return Error{ErrorCode::BadFrame, "an empty frame that promises more"};
    }
    auto open = std::find_if(open_.begin(), open_.end(), [&](const Open& candidate) {
        return candidate.stream == header.stream;
    });
    if (open == open_.end()) {
        if (open_.size() == limits::streams_max) {
            return Error{ErrorCode::TooLarge, "too many messages begun at once"};
        }
        open = open_.insert(open, Open{header.stream, header.type, {}});
    }
    if (open->type != header.type) {
        return Error{ErrorCode::BadFrame, "a message that changes its type midway"};
    }
    if (open->payload.size() + payload.size() > payload_bytes_max(header.type)) {
        return Error{ErrorCode::TooLarge,
                     "message '" + std::string(message_name(header.type)) + "' over its limit of " +
                         std::to_string(payload_bytes_max(header.type)) + " bytes"};
    }
    open->payload.insert(open->payload.end(), payload.begin(), payload.end());
    if (header.has_more) {
        return std::optional<Whole>();
    }
    std::optional<Whole> whole(Whole{open->type, std::move(open->payload)});
    open_.erase(open);
    return whole;
}

} // namespace cd
