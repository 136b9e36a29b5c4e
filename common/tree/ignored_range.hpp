// Pairs of triangles that a search ignores.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace cd {

/// Ignores pairs of triangle ids: a in [a_begin, a_end) with b in [b_begin, b_end). A search gets
/// only the ranges of its two bodies.
struct IgnoredRange {
    std::uint32_t a_begin = 0;
    std::uint32_t a_end = 0;
    std::uint32_t b_begin = 0;
    std::uint32_t b_end = 0;
    std::uint32_t body_a = 0; ///< Index of A in the job's list of bodies.
    std::uint32_t body_b = 1; ///< Index of B in the job's list of bodies.

    friend bool operator==(const IgnoredRange&, const IgnoredRange&) = default;
};

[[nodiscard]] inline bool
is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b) {
    return std::any_of(ignored.begin(), ignored.end(), [&](const IgnoredRange& range) {
        return a >= range.a_begin && a < range.a_end && b >= range.b_begin && b < range.b_end;
    });
}

} // namespace cd
