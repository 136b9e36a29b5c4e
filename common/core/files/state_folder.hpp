// Where programs keep what must outlast them, unless they are told.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// The folder `cdcluster` under $XDG_STATE_HOME, or ~/.local/state, or, without a home, here.
[[nodiscard]] std::filesystem::path state_folder();

/// Makes a folder for its user alone (0700), and those above it as usual. One that is there stays
/// as it is. Errors: Io.
[[nodiscard]] Status make_private_folder(const std::filesystem::path& folder);

} // namespace cd
