// Reads NumPy's .npz: a zip of .npy files.
#pragma once

#include "client/formats/npy.hpp"
#include "client/formats/zip_file.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// One array of an archive, unpacked in pieces.
class NpzArray {
  public:
    NpzArray(NpyHeader header, ZipEntry entry, Bytes begun, std::string place);

    [[nodiscard]] const NpyHeader& header() const { return header_; }
    /// Reads the next elements in the file's order; an empty array at the end. Rows of three
    /// elements are not split. Errors: BadInput naming file and array.
    [[nodiscard]] Result<NpyArray> next();

  private:
    NpyHeader header_;
    ZipEntry entry_;
    Bytes begun_; ///< Data that was unpacked together with the header.
    std::uint64_t bytes_left_;
    std::string place_; ///< File and array, for messages.
};

/// The arrays of an untrusted archive. An array is unpacked on request, up to the size in its
/// header and at most `limits::npz_array_bytes_max`.
class NpzFile {
  public:
    /// Opens an archive. Errors: NotFound and BadInput, both naming the file.
    [[nodiscard]] static Result<NpzFile> open(const std::filesystem::path& path);

    /// Returns the names of all arrays, without ".npy".
    [[nodiscard]] std::vector<std::string> names() const;
    /// Opens an array, which must not outlive this object. Errors: BadInput naming the file and the
    /// array, if it is missing, damaged, or of an unknown type.
    [[nodiscard]] Result<NpzArray> array(const std::string& name) const;
    /// Reads a whole array into memory, in C order. Errors: as `array`.
    [[nodiscard]] Result<NpyArray> read(const std::string& name) const;

  private:
    NpzFile(std::filesystem::path path, ZipFile zip)
        : path_(std::move(path)), zip_(std::move(zip)) {}

    std::filesystem::path path_;
    ZipFile zip_;
};

} // namespace cd
