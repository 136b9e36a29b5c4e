// Reads NumPy's .npz: a zip of .npy files.
#pragma once

#include "client/npy.hpp"
#include "client/zip_file.hpp"
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
    /// The next elements, in the file's order; whole rows of three where there are such. Empty at
    /// the end. Errors: BadInput naming file and array.
    [[nodiscard]] Result<NpyArray> next();

  private:
    NpyHeader header_;
    ZipEntry entry_;
    Bytes begun_; ///< Unpacked with the header.
    std::uint64_t bytes_left_;
    std::string place_; ///< For errors.
};

/// The arrays of an archive. The bytes may be hostile: an array is unpacked when it is asked for,
/// as far as its header says, and at most `limits::npz_array_bytes_max`.
class NpzFile {
  public:
    /// Errors: NotFound; BadInput, naming the file.
    [[nodiscard]] static Result<NpzFile> open(const std::filesystem::path& path);

    /// Without ".npy".
    [[nodiscard]] std::vector<std::string> names() const;
    /// Has to go before the file does. Errors: BadInput naming the file and the array, for one that
    /// is missing, damaged, or of a type that is not known.
    [[nodiscard]] Result<NpzArray> array(const std::string& name) const;
    /// A whole array in memory, in C order. Errors: as of `array`.
    [[nodiscard]] Result<NpyArray> read(const std::string& name) const;

  private:
    NpzFile(std::filesystem::path path, ZipFile zip)
        : path_(std::move(path)), zip_(std::move(zip)) {}

    std::filesystem::path path_;
    ZipFile zip_;
};

} // namespace cd
