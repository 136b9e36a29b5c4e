// The bounds of one frame, and of what a peer may still say that is not listened to.
#pragma once

#include <cstddef>

namespace cd::limits {

inline constexpr std::size_t frame_payload_bytes_max = 1u << 20;
/// Of a frame whose message goes on: so who has begun one has to come to its end.
inline constexpr std::size_t frame_with_more_bytes_min = 256u << 10;
inline constexpr std::size_t refused_tls_bytes_max = 1u << 20;

} // namespace cd::limits
