// How many tests a search for contacts took.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <cstdint>

namespace cd {

/// The paper's N_b and N_p (section 3), and how the pairs were decided.
struct QueryStatistics {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
    PairStatistics decisions;

    QueryStatistics& operator+=(const QueryStatistics& other);
};

} // namespace cd
