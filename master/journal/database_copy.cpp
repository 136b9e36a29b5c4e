#include "master/journal/database_copy.hpp"

#include "common/core/files/disk_file.hpp"

#include <string>
#include <system_error>

namespace cd {

namespace fs = std::filesystem;

Result<DatabaseCopy> DatabaseCopy::make(const fs::path& database) {
    const auto folder = make_temporary_folder("cdmaster");
    if (!folder) {
        return Error{folder.error().code,
                     database.string() + ": cannot be copied to be read: " + folder.error().detail};
    }
    DatabaseCopy copy(folder.value());
    std::error_code error;
    for (const char* part : {"", "-wal"}) {
        fs::copy_file(database.string() + part, copy.path().string() + part, error);
        if (error) {
            return Error{ErrorCode::Io,
                         "cannot copy " + database.string() + part + " to " +
                             folder.value().string() + ": " + error.message()};
        }
    }
    return copy;
}

DatabaseCopy::~DatabaseCopy() {
    std::error_code ignored;
    if (!folder_.empty()) {
        fs::remove_all(folder_, ignored);
    }
}

} // namespace cd
