#include "common/tree/query_statistics.hpp"

namespace cd {

SearchEffort& SearchEffort::operator+=(const SearchEffort& other) {
    cells += other.cells;
    leaves += other.leaves;
    roots_named += other.roots_named;
    roots_used += other.roots_used;
    return *this;
}

QueryStatistics& QueryStatistics::operator+=(const QueryStatistics& other) {
    box_tests += other.box_tests;
    triangle_tests += other.triangle_tests;
    decisions += other.decisions;
    effort += other.effort;
    return *this;
}

} // namespace cd
