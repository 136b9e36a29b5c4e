// Counts the tests of a contact search.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <cstdint>

namespace cd {

/// The numbers of box tests and triangle tests (the paper's N_b and N_p, section 3), and how many
/// pairs each stage decided.
struct QueryStatistics {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
    PairStatistics decisions;

    QueryStatistics& operator+=(const QueryStatistics& other) {
        box_tests += other.box_tests;
        triangle_tests += other.triangle_tests;
        decisions += other.decisions;
        return *this;
    }
};

} // namespace cd
