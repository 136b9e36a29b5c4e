// Varints: unsigned integers in a variable number of bytes, seven bits per byte, lowest bits first.
#pragma once

#include "common/core/files/bytes.hpp"

#include <cstdint>
#include <optional>

namespace cd {

inline void put_varint(ByteWriter& out, std::uint64_t value) {
    while (value >= 0x80) {
        out.put(static_cast<std::uint8_t>(value | 0x80));
        value >>= 7;
    }
    out.put(static_cast<std::uint8_t>(value));
}

/// Reads a varint. Returns nothing if it is cut short, over 64 bits or not in its shortest form.
[[nodiscard]] inline std::optional<std::uint64_t> get_varint(ByteReader& in) {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const auto byte = in.get<std::uint8_t>();
        const std::uint64_t bits = byte & 0x7f;
        const bool fits = (bits << shift) >> shift == bits;
        const bool is_shortest = byte != 0 || shift == 0;
        if (in.failed() || !fits || !is_shortest) {
            return std::nullopt;
        }
        value |= bits << shift;
        if (byte < 0x80) {
            return value;
        }
    }
    return std::nullopt;
}

/// Maps small magnitudes of either sign to small numbers: 0, -1, 1, -2 become 0, 1, 2, 3.
[[nodiscard]] inline std::uint64_t zigzag(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}
[[nodiscard]] inline std::int64_t unzigzag(std::uint64_t value) {
    return static_cast<std::int64_t>((value >> 1) ^ (~(value & 1) + 1));
}

} // namespace cd
