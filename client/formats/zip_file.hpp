// Reads zip archives. No other file reads with libzip.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct zip;
struct zip_file;

namespace cd {

/// Reads one file of an archive sequentially, and unpacks it.
class ZipEntry {
  public:
    /// Returns the unpacked size that the archive's directory gives. The packed bytes can expand to
    /// it, as `ZipFile::entry` has checked.
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// Fills `into` with the next bytes and returns their number. Errors: BadInput if the entry is
    /// damaged or its size differs from `size`, at the end of the entry at the latest.
    [[nodiscard]] Result<std::size_t> read(std::span<std::byte> into);

  private:
    friend class ZipFile;
    struct Close {
        void operator()(zip_file* file) const;
    };

    std::unique_ptr<zip_file, Close> file_;
    std::uint64_t size_ = 0;
    std::uint64_t done_ = 0;
};

class ZipFile {
  public:
    /// Opens an archive. Errors, which do not name the file: NotFound; BadInput for another kind of
    /// file.
    [[nodiscard]] static Result<ZipFile> open(const std::filesystem::path& path);

    /// Returns the names of all files, in the order of the archive.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Opens a file, which must not outlive the archive. Errors: NotFound; BadInput for a damaged
    /// file or an unknown packing.
    [[nodiscard]] Result<ZipEntry> entry(const std::string& name) const;

  private:
    struct Close {
        void operator()(zip* archive) const;
    };

    std::unique_ptr<zip, Close> archive_;
    std::vector<std::string> names_;
};

} // namespace cd
