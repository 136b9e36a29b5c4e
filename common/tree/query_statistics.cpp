#include "common/tree/query_statistics.hpp"

namespace cd {

QueryStatistics& QueryStatistics::operator+=(const QueryStatistics& other) {
    box_tests += other.box_tests;
    triangle_tests += other.triangle_tests;
    decisions += other.decisions;
    return *this;
}

} // namespace cd
