// Where programs keep what must outlast them, unless they are told.
#pragma once

#include <filesystem>

namespace cd {

/// The folder `cdcluster` under $XDG_STATE_HOME, or ~/.local/state, or, without a home, here.
[[nodiscard]] std::filesystem::path state_folder();

} // namespace cd
