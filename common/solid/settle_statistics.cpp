#include "common/solid/settle_statistics.hpp"

namespace cd {

SettleStatistics& SettleStatistics::operator+=(const SettleStatistics& other) {
    points += other.points;
    ray_box_tests += other.ray_box_tests;
    ray_triangle_tests += other.ray_triangle_tests;
    by_exact += other.by_exact;
    searches += other.searches;
    return *this;
}

} // namespace cd
