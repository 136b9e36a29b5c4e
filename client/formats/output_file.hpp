// Writes files that appear under their names only when complete, and reads whole files.
#pragma once

#include "common/core/result.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cd {

/// Writes a file as "NAME.partial" in the target's folder; `commit` syncs it and gives it its name.
/// The destructor removes a file that was not committed.
class OutputFile {
  public:
    /// Creates the partial file. Errors: Io naming the file.
    [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& path);
    /// Writes to standard output, without a partial file.
    [[nodiscard]] static OutputFile standard_output();

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// Appends text. Errors: Io naming the file (a full disk); Incomplete for standard output.
    [[nodiscard]] Status write(std::string_view text);
    [[nodiscard]] Status commit();

  private:
    struct Close {
        void operator()(std::FILE* file) const;
    };

    OutputFile(std::filesystem::path path, std::filesystem::path partial, std::FILE* file)
        : path_(std::move(path)), partial_(std::move(partial)), file_(file) {}

    std::filesystem::path path_;    ///< Empty for standard output.
    std::filesystem::path partial_; ///< Empty for standard output.
    std::unique_ptr<std::FILE, Close> file_;
};

/// Returns the path of the partial file for a target path.
[[nodiscard]] std::filesystem::path partial_path(const std::filesystem::path& path);

/// Writes a file, whole or not at all. Errors: Io naming the file.
[[nodiscard]] Status write_file(const std::filesystem::path& path, std::string_view bytes);

/// Reads all bytes of a file. Errors: NotFound; Io naming the file, also for an empty file.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path);

} // namespace cd
