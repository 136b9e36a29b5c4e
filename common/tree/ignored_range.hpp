// Pairs of triangles that a search passes over.
#pragma once

#include <cstdint>
#include <span>

namespace cd {

/// Pairs of triangle ids that are to be passed over: a in [a_begin, a_end) with b in its range. A
/// search is handed the ranges of the two bodies that it walks.
struct IgnoredRange {
    std::uint32_t a_begin = 0;
    std::uint32_t a_end = 0;
    std::uint32_t b_begin = 0;
    std::uint32_t b_end = 0;
    std::uint32_t body_a = 0; ///< Places of the two bodies in the job's list.
    std::uint32_t body_b = 1;

    friend bool operator==(const IgnoredRange&, const IgnoredRange&) = default;
};

[[nodiscard]] bool
is_ignored(std::span<const IgnoredRange> ignored, std::uint32_t a, std::uint32_t b);

} // namespace cd
