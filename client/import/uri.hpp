// References of mesh files to other bytes: RFC 3986 and RFC 2397.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string_view>

namespace cd {

/// The bytes of `data:[type];base64,...`. Errors: BadInput for what is not base64.
[[nodiscard]] Result<Bytes> decode_data_uri(std::string_view uri);

/// The name of a file in the folder of whoever refers to it, or below. Errors: BadInput for a
/// scheme, an absolute path, and a way up.
[[nodiscard]] Result<std::filesystem::path> relative_file(std::string_view uri);

} // namespace cd
