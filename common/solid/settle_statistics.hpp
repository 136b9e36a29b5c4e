// Counts of the tests that decide whether one body lies inside another.
#pragma once

#include <cstdint>

namespace cd {

/// The work of telling insides, reported apart from the search for contacts.
struct SettleStatistics {
    std::uint64_t points = 0;             ///< Points whose place in a solid was asked.
    std::uint64_t ray_box_tests = 0;      ///< Boxes held against a ray.
    std::uint64_t ray_triangle_tests = 0; ///< Triangles held against a ray.
    std::uint64_t by_exact = 0;           ///< Points for which doubles did not do.
    std::uint64_t searches = 0; ///< Searches for contacts that a result did not hold any more.

    SettleStatistics& operator+=(const SettleStatistics& other);

    friend bool operator==(const SettleStatistics&, const SettleStatistics&) = default;
};

} // namespace cd
