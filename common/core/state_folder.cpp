#include "common/core/state_folder.hpp"

#include <cstdlib>

namespace cd {

std::filesystem::path state_folder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != 0) {
        return std::filesystem::path(state) / "cdcluster";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != 0) {
        return std::filesystem::path(home) / ".local" / "state" / "cdcluster";
    }
    return "cdcluster-state";
}

} // namespace cd
