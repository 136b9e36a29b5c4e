#include "common/core/files/state_folder.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace cd {

std::filesystem::path state_folder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != 0) {
        return std::filesystem::path(state) / "cdcluster";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0) {
        return std::filesystem::path(home) / ".local" / "state" / "cdcluster";
    }
    std::error_code unknown; // If the current folder is unknown, the path stays relative.
    const std::filesystem::path here = std::filesystem::current_path(unknown);
    return here / "cdcluster-state";
}

Status make_private_folder(const std::filesystem::path& folder) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(folder, error);
    // The path may end with a slash.
    const std::filesystem::path last = whole.has_filename() ? whole : whole.parent_path();
    if (!error) {
        std::filesystem::create_directories(last.parent_path(), error);
    }
    if (!error && ::mkdir(last.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
        error = {errno, std::generic_category()};
    }
    if (!error && !std::filesystem::is_directory(last, error)) {
        error = std::make_error_code(std::errc::not_a_directory);
    }
    if (error) {
        return Error{ErrorCode::Io, "cannot create " + folder.string() + ": " + error.message()};
    }
    return Done{};
}

} // namespace cd
