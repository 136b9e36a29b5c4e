// URIs in mesh files: RFC 3986 and RFC 2397.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <string_view>

namespace cd {

/// The bytes of `data:[type];base64,...`. Errors: BadInput for anything but base64.
[[nodiscard]] Result<Bytes> decode_data_uri(std::string_view uri);

/// The relative path of a file in the same folder or below. Errors: BadInput for a URI with a
/// scheme, an absolute path, and a path with "..".
[[nodiscard]] Result<std::filesystem::path> relative_file(std::string_view uri);

} // namespace cd
