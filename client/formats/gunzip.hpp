// Unpacks a .gz file. The only user of zlib.
#pragma once

#include "common/core/result.hpp"

#include <filesystem>

namespace cd {

/// Writes the unpacked bytes of `from` to `to`, which appears only when it is whole.
/// Errors: Io naming the file; BadInput when `from` is damaged.
[[nodiscard]] Status gunzip(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace cd
