// Encodes and decodes messages. The only user of cereal.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "proto/codec/message.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace cd {

/// A message's type number on the wire: its index in `Message`, from 1.
[[nodiscard]] std::uint16_t message_type(const Message& message);
/// Returns the name of a message type for logs; "unknown" for an unknown number.
[[nodiscard]] std::string_view message_name(std::uint16_t type);

/// The largest payload of a type, bytes (limits/wire.hpp): small for control messages, larger for
/// data. 0 for an unknown type.
[[nodiscard]] std::uint64_t payload_bytes_max(std::uint16_t type);

/// Whether a type travels in the data lane. Each lane keeps the order of its messages; control
/// overtakes data.
[[nodiscard]] bool travels_as_data(std::uint16_t type);

/// Encodes the members as a portable little-endian cereal archive. The message must be one that
/// `decode_message` accepts.
[[nodiscard]] Bytes encode_message(const Message& message);

/// Decodes untrusted bytes: checks sizes against the remaining bytes, validates enumerations and
/// cross-references, and allows no bytes after the message. Errors: BadFrame.
[[nodiscard]] Result<Message> decode_message(std::uint16_t type,
                                             std::span<const std::byte> payload);

} // namespace cd
