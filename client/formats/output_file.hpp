// Files that appear under their names only when they are complete, and reading whole files.
#pragma once

#include "common/core/result.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cd {

/// Writes to "NAME.partial" in the target's folder; `commit` syncs and renames the file. The
/// destructor removes an uncommitted file.
class OutputFile {
  public:
    /// Creates the partial file. Errors: Io naming the file.
    [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& path);
    /// Standard output, which has no partial file.
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

/// The path of the partial file for a target path.
[[nodiscard]] std::filesystem::path partial_path(const std::filesystem::path& path);

/// Writes a file, whole or not at all. Errors: those of `OutputFile`.
[[nodiscard]] Status write_file(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a file. Errors: NotFound; Io naming the file, also if it is empty.
[[nodiscard]] Result<std::string> read_file(const std::filesystem::path& path);

} // namespace cd
