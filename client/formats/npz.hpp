// Writes NumPy's .npz: a zip of .npy files.
#pragma once

#include "client/formats/npy.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace cd {

/// Writes an archive whose arrays grow in pieces, without holding them in memory: each array is
/// spooled to a file beside the target. `finish` makes the target appear as a whole.
class NpzWriter {
  public:
    /// `stop` interrupts `finish`, which takes long since it compresses all arrays.
    explicit NpzWriter(std::filesystem::path path, StopCheck stop = {})
        : path_(std::move(path)), stop_(std::move(stop)) {}
    NpzWriter(const NpzWriter&) = delete;
    NpzWriter& operator=(const NpzWriter&) = delete;
    /// Removes the spool files.
    ~NpzWriter();

    /// Adds an array of rows of `columns` elements, or of one dimension if `columns` is 0. Above 1
    /// `rows_each` makes the shape (N, rows_each, columns). Returns the array's number. An error of
    /// the file system is reported by the first `append`.
    std::size_t add_array(const std::string& name,
                          NpyType type,
                          std::uint64_t columns = 0,
                          std::uint64_t rows_each = 1);

    /// Appends elements to an array. Errors: Io naming the file, as soon as a write fails.
    template <class T>
    [[nodiscard]] Status append(std::size_t array, std::span<const T> values) {
        static_assert(std::is_arithmetic_v<T>);
        return append_bytes(array, std::as_bytes(values), sizeof(T));
    }

    /// Completes the archive. Errors: Io naming the file; Interrupted.
    [[nodiscard]] Status finish();

  private:
    struct Array {
        std::string name;
        NpyType type = NpyType::F8;
        std::uint64_t columns = 0;
        std::uint64_t rows_each = 1;
        std::filesystem::path spool = {};
        std::ofstream file = {};
        std::uint64_t elements = 0;
    };

    [[nodiscard]] Status
    append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item);
    [[nodiscard]] static std::vector<std::uint64_t> shape_of(const Array& array);
    [[nodiscard]] bool is_stopped() const { return stop_ && stop_(); }
    void remove_spools();

    std::filesystem::path path_;
    StopCheck stop_;
    std::vector<Array> arrays_;
};

} // namespace cd
