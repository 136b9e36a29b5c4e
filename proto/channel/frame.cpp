#include "proto/channel/frame.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/limits/wire.hpp"
#include "proto/codec/codec.hpp"

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

std::optional<Error> foreign_answer(std::span<const std::byte> first_bytes) {
    // Start of a TLS alert record (RFC 8446, section 5.1), of any version.
    constexpr std::string_view tls_alert = "\x15\x03";
    const std::string_view start(reinterpret_cast<const char*>(first_bytes.data()),
                                 first_bytes.size());
    if (start.starts_with("HTTP/")) {
        return Error{ErrorCode::BadFrame,
                     "a web server answers: that is the master's --http port; give the port of its "
                     "--listen, 7600 by default"};
    }
    if (start.starts_with(tls_alert)) {
        return Error{ErrorCode::Refused, std::string(speaks_tls_text)};
    }
    return std::nullopt;
}

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
        return foreign_answer(bytes).value_or(
            Error{ErrorCode::BadFrame, "no frame of this protocol: wrong magic number"});
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
    if (header.payload_bytes > limits::frame_payload_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "frame of " + std::to_string(header.payload_bytes) + " bytes"};
    }
    return header;
}

std::size_t MessageAssembler::index_of(std::uint32_t stream) const {
    const auto open = std::find_if(
        open_.begin(), open_.end(), [&](const Open& each) { return each.stream == stream; });
    return static_cast<std::size_t>(open - open_.begin());
}

Status MessageAssembler::check(const FrameHeader& header) const {
    const std::string name(message_name(header.type));
    const std::uint64_t bytes_max = payload_bytes_max_from(sender_, header.type);
    if (bytes_max == 0) {
        return Error{ErrorCode::BadFrame,
                     sender_ == Party::Stranger
                         ? "message '" + name + "' before a greeting"
                         : std::string(to_text(sender_)) + " does not send '" + name + "'"};
    }
    // Otherwise a peer could send empty frames forever without progress.
    if (header.has_more && header.payload_bytes == 0) {
        return Error{ErrorCode::BadFrame, "an empty frame that promises more"};
    }
    const std::size_t index = index_of(header.stream);
    const Open* const open = index < open_.size() ? &open_[index] : nullptr;
    if (open == nullptr && open_.size() >= streams_max_of(sender_)) {
        return Error{ErrorCode::TooLarge, "too many messages begun at once"};
    }
    if (open != nullptr && open->type != header.type) {
        return Error{ErrorCode::BadFrame, "a message that changes its type midway"};
    }
    const std::size_t begun = open == nullptr ? 0 : open->payload.size();
    if (begun + header.payload_bytes > bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "message '" + name + "' over its limit of " + std::to_string(bytes_max) +
                         " bytes"};
    }
    return Done{};
}

Result<std::optional<MessageAssembler::Whole>>
MessageAssembler::add(const FrameHeader& header, std::span<const std::byte> payload) {
    if (payload.size() != header.payload_bytes || checksum(payload) != header.payload_checksum) {
        return Error{ErrorCode::BadFrame, "damaged frame payload"};
    }
    if (const Status good = check(header); !good) {
        return good.error();
    }
    auto open = open_.begin() + static_cast<std::ptrdiff_t>(index_of(header.stream));
    if (open == open_.end()) {
        open = open_.insert(open, Open{header.stream, header.type, {}});
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
