// The bounds of the pages for machines (master/net/http_front).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace cd::limits {

inline constexpr std::uint32_t http_request_bytes_max = 16u << 10;
inline constexpr std::size_t http_connections_max = 64; ///< At once; each has one request.
inline constexpr std::chrono::seconds http_exchange_max{10};

} // namespace cd::limits
