// A folder for files that are needed only for a while.
#pragma once

#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace cd {

/// Owns a folder: the destructor removes it with all its files.
class TemporaryFolder {
  public:
    /// Creates an empty folder with `make_temporary_folder`. Errors: Io.
    [[nodiscard]] static Result<TemporaryFolder> make(const std::string& name) {
        TemporaryFolder folder;
        folder.path_.reset(new std::filesystem::path(CD_TRY(make_temporary_folder(name))));
        return folder;
    }

    [[nodiscard]] const std::filesystem::path& path() const { return *path_; }

  private:
    struct Remove {
        void operator()(const std::filesystem::path* path) const {
            std::error_code ignored;
            std::filesystem::remove_all(*path, ignored);
            delete path;
        }
    };

    std::unique_ptr<const std::filesystem::path, Remove> path_;
};

} // namespace cd
