// A triangle of A that lines of a bundle pass through.
#pragma once

#include <cstdint>

namespace cd {

/// A triangle, and the index of the first line that passes through its interior. Both ends of each
/// of these lines are off the triangle's plane.
struct PassedTriangle {
    std::uint32_t slot = 0; ///< Of A.
    std::uint32_t begin = 0;
    std::uint8_t flags = 0; ///< `hit_flag::crosses` and the side.
};

} // namespace cd
