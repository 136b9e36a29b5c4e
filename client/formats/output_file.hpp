// A file that appears under its name only when it is whole.
#pragma once

#include "common/core/result.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace cd {

/// Written as "NAME.partial" beside its place; `commit` flushes it to the disk and renames it. What
/// was not committed is removed.
class OutputFile {
  public:
    /// Errors: Io naming the file.
    [[nodiscard]] static Result<OutputFile> create(const std::filesystem::path& path);
    /// Standard output, which is only ever appended to.
    [[nodiscard]] static OutputFile standard_output();

    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    /// Errors: Io naming the file (a full disk); Incomplete for standard output.
    [[nodiscard]] Status write(std::string_view text);
    [[nodiscard]] Status commit();

  private:
    struct Close {
        void operator()(std::FILE* file) const;
    };

    OutputFile(std::filesystem::path path, std::filesystem::path partial, std::FILE* file)
        : path_(std::move(path)), partial_(std::move(partial)), file_(file) {}

    [[nodiscard]] Error failure() const;

    std::filesystem::path path_;    ///< Empty for standard output.
    std::filesystem::path partial_; ///< Empty for standard output.
    std::unique_ptr<std::FILE, Close> file_;
};

/// Where a file of that name is written until it is whole.
[[nodiscard]] std::filesystem::path partial_path(const std::filesystem::path& path);

} // namespace cd
