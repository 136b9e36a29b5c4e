// The interface of files of named arrays that grow in pieces.
#pragma once

#include "common/core/files/npy_header.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace cd {

/// What is known of an array before its elements.
struct ArrayLayout {
    std::string name;
    NpyType type = NpyType::F8;
    std::uint64_t columns = 0;   ///< Elements of a row; 0: the array has one dimension.
    std::uint64_t rows_each = 1; ///< Above 1: the shape is (N, rows_each, columns).

    /// Returns the shape with so many elements.
    [[nodiscard]] std::vector<std::uint64_t> shape_of(std::uint64_t elements) const;
};

/// A file of arrays that need not fit into memory. The file appears under its name when `finish`
/// has completed it; without that, nothing is left.
class ArrayFile {
  public:
    explicit ArrayFile(std::filesystem::path path) : path_(std::move(path)) {}
    ArrayFile(const ArrayFile&) = delete;
    ArrayFile& operator=(const ArrayFile&) = delete;
    virtual ~ArrayFile() = default;

    /// Adds an array, which has no elements yet. Returns its number. An error of the file system is
    /// reported by the first `append`.
    [[nodiscard]] virtual std::size_t add_array(const ArrayLayout& layout) = 0;

    /// Appends elements to an array. Errors: Io naming the file, as soon as a write fails.
    template <class T>
    [[nodiscard]] Status append(std::size_t array, std::span<const T> values) {
        static_assert(std::is_arithmetic_v<T>);
        return append_bytes(array, std::as_bytes(values), sizeof(T));
    }

    /// Completes the file. Errors: Io naming the file; Interrupted.
    [[nodiscard]] virtual Status finish() = 0;

  protected:
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Returns the name of the file while it is incomplete.
    [[nodiscard]] std::filesystem::path temporary_path() const { return path_.string() + ".part"; }
    [[nodiscard]] Error cannot_write(const std::string& why) const;
    /// Flushes the temporary file to the disk and gives it its final name. Errors: Io.
    [[nodiscard]] Status commit() const;

  private:
    /// Appends elements of `item` bytes, which is the size of the array's type.
    [[nodiscard]] virtual Status
    append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item) = 0;

    std::filesystem::path path_;
};

/// The formats of array files, which are also the endings of their names.
inline constexpr std::array<std::string_view, 2> array_formats{"npz", "h5"};

[[nodiscard]] bool is_array_format(std::string_view format);

/// Makes the file `dir`/`stem`.`format` of a format in `array_formats`. `stop` interrupts what
/// takes long.
[[nodiscard]] std::unique_ptr<ArrayFile> make_array_file(std::string_view format,
                                                         const std::filesystem::path& dir,
                                                         std::string_view stem,
                                                         StopCheck stop = {});

} // namespace cd
