// Encodes and decodes messages. The only user of cereal.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "proto/codec/message.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Encodes the members as a portable little-endian cereal archive. The message must be one that
/// `decode_message` accepts.
[[nodiscard]] Bytes encode_message(const Message& message);

/// Decodes untrusted bytes: checks sizes against the remaining bytes, validates enumerations and
/// cross-references, and allows no bytes after the message. Errors: BadFrame.
[[nodiscard]] Result<Message> decode_message(std::uint16_t type,
                                             std::span<const std::byte> payload);

} // namespace cd
