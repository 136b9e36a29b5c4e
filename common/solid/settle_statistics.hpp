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
    /// Contact searches repeated because a result did not hold its contacts.
    std::uint64_t searches = 0;

    SettleStatistics& operator+=(const SettleStatistics& other) {
        points += other.points;
        ray_box_tests += other.ray_box_tests;
        ray_triangle_tests += other.ray_triangle_tests;
        by_exact += other.by_exact;
        searches += other.searches;
        return *this;
    }

    friend bool operator==(const SettleStatistics&, const SettleStatistics&) = default;
};

} // namespace cd
