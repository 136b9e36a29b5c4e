// Counts of the tests that decide whether one body lies inside another.
#pragma once

#include <cstdint>

namespace cd {

/// The work of point-in-solid tests, counted apart from the search for contacts.
struct SettleStatistics {
    std::uint64_t points = 0;             ///< Points classified against a solid.
    std::uint64_t ray_box_tests = 0;      ///< Boxes tested against a ray.
    std::uint64_t ray_triangle_tests = 0; ///< Triangles tested against a ray.
    std::uint64_t by_exact = 0;           ///< Points that doubles could not decide.
    std::uint64_t searches =
        0; ///< Contact searches repeated because a result did not hold its contacts.

    SettleStatistics& operator+=(const SettleStatistics& other);

    friend bool operator==(const SettleStatistics&, const SettleStatistics&) = default;
};

} // namespace cd
