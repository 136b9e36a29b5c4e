// Helpers to read and write the journal's rows.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/core/varint.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Returns the error for a row whose bytes are no valid encoding of `what`.
[[nodiscard]] inline Error damaged_row(const char* what) {
    return {ErrorCode::BadFrame, std::string(what) + " that is none"};
}

/// Returns whether the rest of the bytes has room for `count` items of `bytes_each` bytes. Checked
/// first, so that a damaged count allocates nothing.
[[nodiscard]] inline bool
may_hold(const ByteReader& in, std::uint64_t count, std::uint64_t bytes_each) {
    return count <= in.remaining() / bytes_each;
}

template <class Enumeration>
[[nodiscard]] bool get_enumeration(ByteReader& in, Enumeration& value, Enumeration last) {
    const auto number = in.get<std::uint8_t>();
    value = static_cast<Enumeration>(number);
    return number <= static_cast<std::uint8_t>(last);
}

template <class Enumeration>
void put_enumeration(ByteWriter& out, Enumeration value) {
    out.put(static_cast<std::uint8_t>(value));
}

} // namespace cd
