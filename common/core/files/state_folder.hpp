// The default folder for persistent state.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// Returns `cdcluster` in $XDG_STATE_HOME, or else in $HOME/.local/state. If neither variable is
/// set, returns `cdcluster-state` in the current folder, as an absolute path, so that help texts
/// and logs show where it is.
[[nodiscard]] std::filesystem::path state_folder();

/// Creates a folder with mode 0700, and its parents with the default mode. Leaves an existing
/// folder unchanged. Errors: Io.
[[nodiscard]] Status make_private_folder(const std::filesystem::path& folder);

} // namespace cd
