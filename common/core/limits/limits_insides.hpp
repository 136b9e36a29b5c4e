// Bounds on what is prepared to tell whether one body lies inside the other.
#pragma once

#include <cstddef>

namespace cd::limits {

/// With more ignored ranges a scenario's class does not tell `inside`.
inline constexpr std::size_t inside_ignored_max = 4096;
/// The class does not tell `inside` either when the triangles of one body differ in more ways by
/// the ranges of the other body that are ignored with them.
inline constexpr std::size_t inside_kinds_max = 256;

} // namespace cd::limits
