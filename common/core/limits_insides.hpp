// Bounds on what is prepared to tell whether one body lies inside the other.
#pragma once

#include <cstddef>

namespace cd::limits {

/// With more ignored pairs of parts nothing is said of insides.
inline constexpr std::size_t inside_ignored_max = 4096;
/// Nor with more kinds of triangles in one body, by what of the other body is ignored.
inline constexpr std::size_t inside_kinds_max = 256;

} // namespace cd::limits
