#include "client/base/cache_folder.hpp"

#include <cstdlib>

namespace cd {

std::optional<std::filesystem::path> own_cache_dir() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache == '/') {
        return std::filesystem::path(cache) / "cdcluster";
    }
    const char* home = std::getenv("HOME");
    if (home != nullptr && *home == '/') {
        return std::filesystem::path(home) / ".cache" / "cdcluster";
    }
    return std::nullopt;
}

std::filesystem::path cache_dir() {
    const auto own = own_cache_dir();
    return own ? *own : std::filesystem::temp_directory_path() / "cdcluster";
}

} // namespace cd
