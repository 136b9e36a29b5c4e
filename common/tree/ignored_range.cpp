#include "common/tree/ignored_range.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

std::pair<std::uint32_t, std::uint32_t> bodies_of(const IgnoredRange& range) {
    return {range.body_a, range.body_b};
}

} // namespace

bool is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRange& range) {
        return a >= range.a_begin && a < range.a_end && b >= range.b_begin && b < range.b_end;
    });
}

bool are_in_order(std::span<const IgnoredRange> ignored) {
    return std::ranges::is_sorted(ignored, {}, bodies_of) &&
           std::ranges::all_of(
               ignored, [](const IgnoredRange& range) { return range.body_a < range.body_b; });
}

std::span<const IgnoredRange>
ignored_of(std::span<const IgnoredRange> ignored, std::uint32_t body_a, std::uint32_t body_b) {
    const auto found = std::ranges::equal_range(ignored, std::pair(body_a, body_b), {}, bodies_of);
    return {found.begin(), found.end()};
}

} // namespace cd
