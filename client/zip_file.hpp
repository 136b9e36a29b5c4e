// Reads zip archives. The only reader of libzip.
#pragma once

#include "common/core/bytes.hpp"
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

/// The unpacked bytes of one file of an archive, in turn.
class ZipEntry {
  public:
    /// What the archive says that it unpacks to: no more than its packed bytes can make.
    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// As many bytes as fit or are left. Errors: BadInput where the entry is damaged or longer or
    /// shorter than it says, at its end at the latest.
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
    /// Errors: NotFound; BadInput for what is no archive. Neither names the file.
    [[nodiscard]] static Result<ZipFile> open(const std::filesystem::path& path);

    /// In the archive's order.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Has to go before the archive does. Errors: NotFound; BadInput where it is damaged.
    [[nodiscard]] Result<ZipEntry> entry(const std::string& name) const;

  private:
    struct Close {
        void operator()(zip* archive) const;
    };

    std::unique_ptr<zip, Close> archive_;
    std::vector<std::string> names_;
};

} // namespace cd
