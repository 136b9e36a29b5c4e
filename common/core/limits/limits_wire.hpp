// The bounds of one frame, of what a peer may still say that is not listened to, and of a silence.
#pragma once

#include <cstddef>

namespace cd::limits {

inline constexpr std::size_t frame_payload_bytes_max = 1u << 20;
/// Of a frame whose message goes on: so who has begun one has to come to its end.
inline constexpr std::size_t frame_with_more_bytes_min = 256u << 10;
inline constexpr std::size_t refused_tls_bytes_max = 1u << 20;

// So a connection whose other host is gone ends within half a minute, also where neither end says
// anything for long, as while a client waits for a large mesh to be taken in.
inline constexpr int keepalive_idle_seconds = 15;
inline constexpr int keepalive_period_seconds = 5;
inline constexpr int keepalive_probes = 3;

} // namespace cd::limits
