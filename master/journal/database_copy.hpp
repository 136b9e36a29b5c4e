// A temporary copy of an SQLite database from a read-only folder.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>
#include <utility>

namespace cd {

/// A copy of a database and its write-ahead log. SQLite needs a writable folder to read such a log.
/// The destructor deletes the copy.
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
