// A database of SQLite with its log, copied from where nothing can be written.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <utility>

namespace cd {

/// SQLite reads a log only where it may write beside it. The copy is gone with the object.
class DatabaseCopy {
  public:
    /// Copies the file and its "-wal" into a temporary folder. Errors: Io.
    [[nodiscard]] static Result<DatabaseCopy> make(const std::filesystem::path& database);

    DatabaseCopy(DatabaseCopy&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
    DatabaseCopy& operator=(DatabaseCopy&&) = delete;
    ~DatabaseCopy();

    [[nodiscard]] std::filesystem::path path() const { return folder_ / "copy.db"; }

  private:
    explicit DatabaseCopy(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;
};

} // namespace cd
