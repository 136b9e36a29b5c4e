// The pairs of boxes that overlap, by testing all pairs.
#pragma once

#include "common/scene/box_sweep.hpp"

#include <span>
#include <vector>

namespace cd::tests {

[[nodiscard]] inline bool overlap(const WorldBox& a, const WorldBox& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) {
            return false;
        }
    }
    return true;
}

/// Returns the pairs of boxes that share a point, sorted.
[[nodiscard]] inline std::vector<BodyPair> all_overlaps(std::span<const WorldBox> boxes) {
    std::vector<BodyPair> pairs;
    for (std::uint32_t a = 0; a < boxes.size(); ++a) {
        for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
            if (overlap(boxes[a], boxes[b])) {
                pairs.push_back({a, b});
            }
        }
    }
    return pairs;
}

} // namespace cd::tests
