// Encodes columns of values as byte planes: all lowest bytes, then all second ones, and so on.
// Exponents and leading digits, which resemble each other, are then adjacent and compress well.
#pragma once

#include "common/core/files/bytes.hpp"

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace cd {

/// Writes the lowest `planes` bytes of each value; the other bytes are 0.
template <std::unsigned_integral T>
void put_planes(ByteWriter& out, std::span<const T> values, std::size_t planes = sizeof(T)) {
    std::vector<std::uint8_t> plane(values.size());
    for (std::size_t k = 0; k < planes; ++k) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            plane[i] = static_cast<std::uint8_t>(values[i] >> (8 * k));
        }
        out.put_array(std::span<const std::uint8_t>(plane));
    }
}

/// Reads what `put_planes` wrote. Returns an empty vector when the bytes end early.
template <std::unsigned_integral T>
std::vector<T> get_planes(ByteReader& in, std::size_t count, std::size_t planes = sizeof(T)) {
    const std::span<const std::byte> bytes = in.get_bytes(planes * std::uint64_t{count});
    if (in.failed()) {
        return {};
    }
    std::vector<T> values(count);
    for (std::size_t k = 0; k < planes; ++k) {
        const std::byte* const plane = bytes.data() + k * count;
        for (std::size_t i = 0; i < count; ++i) {
            values[i] = static_cast<T>(values[i] | static_cast<T>(plane[i]) << (8 * k));
        }
    }
    return values;
}

/// Returns the number of bytes that the largest of these values needs.
[[nodiscard]] inline std::size_t planes_for(std::span<const std::uint32_t> values) {
    std::uint32_t bits = 0;
    for (const std::uint32_t value : values) {
        bits |= value;
    }
    std::size_t planes = 0;
    for (; bits != 0; bits >>= 8) {
        ++planes;
    }
    return planes;
}

// ---- Floats ----------------------------------------------------------------------------------

template <class Float>
using BitsOf = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;

/// Writes a column of `count` numbers; `number(i)` returns number i.
template <class Float, class Number>
void put_column(ByteWriter& out, std::size_t count, const Number& number) {
    std::vector<BitsOf<Float>> bits(count);
    for (std::size_t i = 0; i < count; ++i) {
        bits[i] = std::bit_cast<BitsOf<Float>>(static_cast<Float>(number(i)));
    }
    put_planes(out, std::span<const BitsOf<Float>>(bits));
}

/// Reads a column of `count` numbers and assigns number i to the reference `number(i)`. Returns
/// false when the bytes end early.
template <class Float, class Number>
bool get_column(ByteReader& in, std::size_t count, const Number& number) {
    const auto bits = get_planes<BitsOf<Float>>(in, count);
    if (in.failed()) {
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        number(i) = std::bit_cast<Float>(bits[i]);
    }
    return true;
}

} // namespace cd
