// Writes HDF5 files.
#pragma once

#include "client/formats/array_file.hpp"
#include "common/core/files/bytes.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cd {

/// Writes an HDF5 file whose arrays are chunked and compressed. Memory has one chunk of each array.
/// A `/` in a name makes a group. Any number of threads may write files, since each call waits for
/// the others: the library is not made for threads.
class H5Writer final : public ArrayFile {
  public:
    explicit H5Writer(std::filesystem::path path);
    ~H5Writer() override;

    [[nodiscard]] std::size_t add_array(const ArrayLayout& layout) override;
    [[nodiscard]] Status finish() override;

  private:
    struct Array {
        ArrayLayout layout;
        std::int64_t id = -1;        ///< Of the library; negative if the array has not been made.
        Bytes waiting = {};          ///< Elements that are not in the file yet.
        std::uint64_t elements = 0;  ///< In the file.
        std::uint64_t row_bytes = 0; ///< Of an index of the first dimension.
        std::uint64_t chunk_rows = 0;
    };

    [[nodiscard]] Status
    append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item) override;
    [[nodiscard]] Status write_rows(Array& array) const;
    [[nodiscard]] bool close();

    std::int64_t file_ = -1; ///< The library's number of the open file; negative without one.
    std::vector<Array> arrays_;
};

} // namespace cd
