#include "master/journal/database_copy.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

namespace cd {

namespace fs = std::filesystem;

Result<DatabaseCopy> DatabaseCopy::make(const fs::path& database) {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "cdmaster-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) {
        return Error{ErrorCode::Io, "cannot make a temporary folder to read " + database.string()};
    }
    DatabaseCopy copy(name);
    for (const char* part : {"", "-wal"}) {
        fs::copy_file(database.string() + part, copy.path().string() + part, error);
        if (error) {
            return Error{ErrorCode::Io,
                         "cannot copy " + database.string() + part + " to " + name + ": " +
                             error.message()};
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
