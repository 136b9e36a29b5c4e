// Pairs of triangles that a search ignores.
#pragma once

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

[[nodiscard]] bool
is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b);

/// Whether the ranges of a job are in order: each names body A before body B, and the pairs of
/// bodies ascend.
[[nodiscard]] bool are_in_order(std::span<const IgnoredRange> ignored);

/// Returns the ranges of a pair of bodies, from the ranges of a job, which are in order.
[[nodiscard]] std::span<const IgnoredRange>
ignored_of(std::span<const IgnoredRange> ignored, std::uint32_t body_a, std::uint32_t body_b);

} // namespace cd
