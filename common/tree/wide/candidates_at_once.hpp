// How many candidates a search lets the descent find before it decides them.
#pragma once

#include <cstddef>

namespace cd {

/// Deciding many at once is faster.
inline constexpr std::size_t candidates_at_once = 512;
/// A search for a first contact may end after each candidate.
inline constexpr std::size_t candidates_at_once_for_any = 1;

} // namespace cd
