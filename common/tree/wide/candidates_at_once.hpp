// How many candidates the descent collects before a search decides them.
#pragma once

#include <cstddef>

namespace cd {

/// Deciding many candidates together is faster.
inline constexpr std::size_t candidates_at_once = 512;
/// A search for a first contact may end after each candidate, so it takes them singly.
inline constexpr std::size_t candidates_at_once_for_any = 1;

} // namespace cd
