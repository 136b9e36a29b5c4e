// The header of NumPy's array format:
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cd {

/// Supported element types, all little-endian.
enum class NpyType : std::uint8_t { F8, F4, I8, I4, I2, I1, U8, U4, U2, U1 };

[[nodiscard]] std::size_t size_of(NpyType type);
/// Returns the type in NumPy's notation: "<f8".
[[nodiscard]] std::string_view to_text(NpyType type);

struct NpyHeader {
    NpyType type = NpyType::F8;
    bool is_fortran = false; ///< Elements are in Fortran order: the first index varies fastest.
    std::vector<std::uint64_t> shape;
    std::size_t data_offset = 0; ///< Offset of the first element in the file.

    /// Returns the number of elements; 2^64 - 1 if there are more.
    [[nodiscard]] std::uint64_t count() const;
};

/// The maximum size of a header in bytes; the headers that NumPy writes have about 100.
inline constexpr std::size_t npy_header_bytes_max = (1u << 16) + 16;

/// Reads the header from the first bytes of an untrusted array file. Errors: BadInput with the
/// reason: not an array, an unsupported type, big-endian, damaged.
[[nodiscard]] Result<NpyHeader> parse_npy_header(std::span<const std::byte> file);

/// The size in bytes of every header that `make_npy_header` makes.
inline constexpr std::size_t npy_header_bytes = 128;
[[nodiscard]] Bytes make_npy_header(NpyType type, std::span<const std::uint64_t> shape);

} // namespace cd
