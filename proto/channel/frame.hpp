// Frames: the pieces of messages on a byte stream (PROTOCOL.md).
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "proto/messages/party.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cd {

inline constexpr std::size_t frame_header_bytes = 32;

/// The fixed header, little-endian on the wire: magic, type, flags, stream, payload length, session
/// epoch, checksum of the payload, checksum of the header.
struct FrameHeader {
    std::uint16_t type = 0;
    bool has_more = false; ///< The next frame of this stream continues the message.
    std::uint32_t stream = 0;
    std::uint32_t payload_bytes = 0;
    std::uint32_t epoch = 0; ///< Always 0; receivers ignore it.
    std::uint64_t payload_checksum = 0;

    friend bool operator==(const FrameHeader&, const FrameHeader&) = default;
};

[[nodiscard]] std::array<std::byte, frame_header_bytes> encode_header(const FrameHeader& header);
/// Errors: BadFrame for a wrong magic, checksum, flag or type; TooLarge for an overlong length.
[[nodiscard]] Result<FrameHeader>
decode_header(std::span<const std::byte, frame_header_bytes> bytes);

/// The answer to a peer that connects without TLS where TLS is required.
inline constexpr std::string_view speaks_tls_text =
    "the master speaks TLS: cdctl join gets a credential, cdworker takes a --token";

/// Returns an error if the first bytes come from a web server or a TLS endpoint, else nothing.
[[nodiscard]] std::optional<Error> foreign_answer(std::span<const std::byte> first_bytes);

/// Assembles messages from frames; a state machine without I/O. Holds at most
/// `payload_bytes_max_from` bytes per message, on at most `streams_max_of` streams.
class MessageAssembler {
  public:
    /// A complete message, not yet decoded.
    struct Whole {
        std::uint16_t type = 0;
        Bytes payload;
    };

    /// Sets the party of the sender; initially Anyone.
    void expect(Party sender) { sender_ = sender; }
    [[nodiscard]] Party sender() const { return sender_; }

    /// Checks by its header alone whether a frame is allowed now. Errors: those of `add`.
    [[nodiscard]] Status check(const FrameHeader& header) const;

    /// Adds a frame. Returns the message that the frame completes, or nothing if more frames of it
    /// follow. Errors: BadFrame, TooLarge; the caller then ends the connection.
    [[nodiscard]] Result<std::optional<Whole>> add(const FrameHeader& header,
                                                   std::span<const std::byte> payload);

    /// Whether any message is incomplete.
    [[nodiscard]] bool has_begun() const { return !open_.empty(); }

  private:
    /// An incomplete message.
    struct Open {
        std::uint32_t stream = 0;
        std::uint16_t type = 0;
        Bytes payload;
    };
    /// Returns the index in `open_` of a stream's message, or the number of all if there is none.
    [[nodiscard]] std::size_t index_of(std::uint32_t stream) const;

    std::vector<Open> open_;
    Party sender_ = Party::Anyone;
};

} // namespace cd
