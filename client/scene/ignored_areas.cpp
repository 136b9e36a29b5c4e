#include "client/scene/ignored_areas.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace cd {

namespace {

/// Appends the pairs with a in [a_begin, a_end) and b in [b_begin, b_end), if there are any.
void add_part(IgnoredAreas& areas, IgnoredRange part) {
    if (part.a_begin < part.a_end && part.b_begin < part.b_end) {
        areas.push_back(part);
    }
}

} // namespace

void subtract(IgnoredAreas& areas, const IgnoredRange& hole) {
    IgnoredAreas left;
    for (const IgnoredRange& area : areas) {
        // The part of the hole within the area; its ends are within those of the area.
        const std::uint32_t a_begin = std::clamp(hole.a_begin, area.a_begin, area.a_end);
        const std::uint32_t a_end = std::clamp(hole.a_end, a_begin, area.a_end);
        const std::uint32_t b_begin = std::clamp(hole.b_begin, area.b_begin, area.b_end);
        const std::uint32_t b_end = std::clamp(hole.b_end, b_begin, area.b_end);
        if (a_begin == a_end || b_begin == b_end) {
            left.push_back(area);
            continue;
        }
        const auto part = [&](std::uint32_t from_a,
                              std::uint32_t to_a,
                              std::uint32_t from_b,
                              std::uint32_t to_b) {
            add_part(left, {from_a, to_a, from_b, to_b, area.body_a, area.body_b});
        };
        part(area.a_begin, a_begin, area.b_begin, area.b_end);
        part(a_begin, a_end, area.b_begin, b_begin);
        part(a_begin, a_end, b_end, area.b_end);
        part(a_end, area.a_end, area.b_begin, area.b_end);
    }
    areas = std::move(left);
}

} // namespace cd
