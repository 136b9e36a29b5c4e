// Round robin over the entries of a map.
#pragma once

namespace cd {

/// Returns the first wanted entry, searching from the key after `last` around to `last`. Null if
/// no entry is wanted.
template <class Map, class Key, class IsWanted>
auto* next_in_turn(Map& map, const Key& last, const IsWanted& is_wanted) {
    const auto next = map.upper_bound(last);
    for (auto place = next; place != map.end(); ++place) {
        if (is_wanted(*place)) {
            return &*place;
        }
    }
    for (auto place = map.begin(); place != next; ++place) {
        if (is_wanted(*place)) {
            return &*place;
        }
    }
    return static_cast<decltype(&*map.begin())>(nullptr);
}

} // namespace cd
