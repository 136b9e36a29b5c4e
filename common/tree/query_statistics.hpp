// Counts the tests of a search.
#pragma once

#include "common/pair/triangle_pair.hpp"

#include <cstdint>

namespace cd {

/// What the search for the answers of motions or of distances takes. No answer depends on it.
struct SearchEffort {
    std::uint64_t cells = 0;       ///< Cells of time that the search of a motion tests.
    std::uint64_t leaves = 0;      ///< Those of `cells` that it does not halve.
    std::uint64_t roots_named = 0; ///< Pairs of distribution roots that may have a distance.
    std::uint64_t roots_used = 0;  ///< Those of `roots_named` that the search for it takes.

    SearchEffort& operator+=(const SearchEffort& other);
    friend bool operator==(const SearchEffort&, const SearchEffort&) = default;
};

/// The numbers of box tests and triangle tests (the paper's N_b and N_p, section 3), and how many
/// pairs each stage decided.
struct QueryStatistics {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
    PairStatistics decisions;
    SearchEffort effort = {}; ///< Zero unless the query asks for motions or distances.

    QueryStatistics& operator+=(const QueryStatistics& other);
};

} // namespace cd
