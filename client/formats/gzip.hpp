// Compresses bytes in the gzip format (RFC 1952).
#pragma once

#include "common/core/files/bytes.hpp"

#include <cstddef>
#include <span>

namespace cd {

/// Returns one gzip member without a name and a time.
[[nodiscard]] Bytes gzip(std::span<const std::byte> bytes);

} // namespace cd
