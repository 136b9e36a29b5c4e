// Messages to bytes and back. The only user of cereal.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "proto/codec/message.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace cd {

/// A message's number on the wire: its place in `Message`, from 1.
[[nodiscard]] std::uint16_t message_type(const Message& message);
/// For logs. "unknown" for a number that no message has.
[[nodiscard]] std::string_view message_name(std::uint16_t type);

/// The largest payload of a type: control messages are small, data messages larger (limits.hpp).
/// 0 for an unknown type.
[[nodiscard]] std::uint64_t payload_bytes_max(std::uint16_t type);

/// True for what goes in the lane of data. Messages of one lane keep their order; control overtakes
/// data.
[[nodiscard]] bool travels_as_data(std::uint16_t type);

/// Portable binary (little-endian) cereal archive of the message's members. A message that
/// `decode_message` would refuse is a bug.
[[nodiscard]] Bytes encode_message(const Message& message);

/// The bytes may be hostile: a size is believed only as far as bytes are there for it, enumerations
/// and cross-references are validated, nothing may be left over. Errors: BadFrame.
[[nodiscard]] Result<Message> decode_message(std::uint16_t type,
                                             std::span<const std::byte> payload);

} // namespace cd
