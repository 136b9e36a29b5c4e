// Arrays in NumPy files.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/npy_header.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cd {

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
