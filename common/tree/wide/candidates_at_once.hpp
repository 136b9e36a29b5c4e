// How many candidates the descent collects before a search decides them.
#pragma once

#include <cstddef>

namespace cd {

/// A search for all contacts decides this many candidates together, because that is faster.
inline constexpr std::size_t candidates_at_once = 512;
/// A search for a first contact decides candidates singly, because it may end after each.
inline constexpr std::size_t candidates_at_once_for_any = 1;
/// A search for the nearest pair decides few together, because each may narrow the search.
inline constexpr std::size_t candidates_at_once_for_nearest = 16;

} // namespace cd
