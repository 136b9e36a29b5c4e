// The bounds of one frame, and of what a peer may still say that is not listened to.
#pragma once

#include <cstddef>

namespace cd::limits {

inline constexpr std::size_t frame_payload_bytes_max = 1u << 20;
inline constexpr std::size_t refused_tls_bytes_max = 1u << 20;

} // namespace cd::limits
