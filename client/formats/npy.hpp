// NumPy's array format: https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
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

/// A whole array in memory, in C order.
struct NpyArray {
    std::vector<std::uint64_t> shape;
    NpyType type = NpyType::F8;
    Bytes data;

    /// Converts all elements to doubles; integers beyond 2^53 are rounded.
    [[nodiscard]] std::vector<double> to_doubles() const;
    /// Converts all elements to integers of 64 bits. Errors: BadInput if the type is not an integer
    /// or an element does not fit.
    [[nodiscard]] Result<std::vector<std::int64_t>> to_integers() const;
};

/// Makes an array from a header and from data whose size the caller has checked.
[[nodiscard]] NpyArray make_npy_array(const NpyHeader& header, Bytes data);

/// Parses a whole array file. Errors: as `parse_npy_header`; BadInput if the number of elements
/// differs from the header's.
[[nodiscard]] Result<NpyArray> parse_npy(std::span<const std::byte> file);

/// The rows of an array file, one for each value of the first index, read on demand and as doubles.
/// Arrays in Fortran order are loaded whole.
class NpyRows {
  public:
    /// Opens a file. Errors: NotFound; Io; as `parse_npy_header`, naming the file.
    [[nodiscard]] static Result<std::unique_ptr<NpyRows>> open(const std::filesystem::path& path);
    /// Gives access to the rows of an array in memory.
    [[nodiscard]] static std::unique_ptr<NpyRows> of(NpyArray array);

    [[nodiscard]] const std::vector<std::uint64_t>& shape() const { return shape_; }
    [[nodiscard]] std::uint64_t row_count() const { return shape_.front(); }
    [[nodiscard]] std::uint64_t row_size() const; ///< Number of elements in a row.
    /// Reads rows [first, first + count), which must exist. Errors: Io.
    [[nodiscard]] Result<std::vector<double>> read(std::uint64_t first, std::uint64_t count);

  private:
    NpyRows() = default;
    [[nodiscard]] Result<Bytes> read_bytes(std::uint64_t offset, std::uint64_t count);

    std::vector<std::uint64_t> shape_;
    NpyType type_ = NpyType::F8;
    std::ifstream file_;
    std::size_t data_offset_ = 0;
    std::optional<Bytes> data_; ///< Set for an array in memory; otherwise rows are in `file_`.
    std::string name_;
};

} // namespace cd
