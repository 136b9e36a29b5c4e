// Keeps arrays that grow in pieces on the disk until their number of elements is known.
#pragma once

#include "client/formats/number_array.hpp"
#include "common/core/check.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// An array in a temporary file, which the destructor removes. Memory: one buffer.
class ArraySpool {
  public:
    /// Creates the file beside `path`. Errors: Io naming the file.
    [[nodiscard]] static Result<ArraySpool> create(const std::filesystem::path& path, NpyType type);

    /// Appends numbers. Errors: Io naming the file.
    template <class Number>
    [[nodiscard]] Status append(std::span<const Number> numbers) {
        CD_CHECK(npy_type<Number>() == type_);
        return append_bytes(std::as_bytes(numbers));
    }
    template <class Number>
    [[nodiscard]] Status append(Number number) {
        return append(std::span<const Number>(&number, 1));
    }

    /// Writes what is buffered, and returns the array, which must not outlive this object. Errors:
    /// Io naming the file.
    [[nodiscard]] Result<NumberArray> finish();

  private:
    ArraySpool(DiskFile file, NpyType type)
        : file_(std::make_unique<DiskFile>(std::move(file))), type_(type) {}

    [[nodiscard]] Status append_bytes(std::span<const std::byte> bytes);
    [[nodiscard]] Status flush();

    std::unique_ptr<DiskFile> file_; ///< On the heap: `finish` returns a function that reads it.
    NpyType type_;
    Bytes buffer_;
    std::uint64_t bytes_written_ = 0;
};

} // namespace cd
