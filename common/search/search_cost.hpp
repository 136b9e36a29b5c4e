// Measures the time of a search's tests on this machine: the constants of the paper's cost
// function.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/tree/obb_tree.hpp"

#include <chrono>
#include <optional>
#include <span>

namespace cd {

struct QueryStatistics;

/// The paper's C_b and C_p (section 3), in nanoseconds. A search with N_b box tests and N_p
/// triangle tests costs N_b C_b + N_p C_p, besides its work with the contacts that it finds.
struct SearchCost {
    double box_test_ns = 0;
    double triangle_test_ns = 0;

    /// Returns N_b C_b + N_p C_p, in seconds.
    [[nodiscard]] double seconds_of(const QueryStatistics& statistics) const;

    friend bool operator==(const SearchCost&, const SearchCost&) = default;
};

struct SearchCostOptions {
    bool for_any = false; ///< Searches for a first contact, as `level any` does.
    PairStage first_stage = PairStage::Float;
    /// No further pose is measured after this time; the first pose is always measured.
    std::chrono::steady_clock::duration time_max = std::chrono::milliseconds(50);
};

/// Searches the wide trees under one pose after another as WideSearch does, on the calling thread,
/// and reads the clock between descent and decisions. Each constant is the median cost per test, so
/// a pose under which the thread had to wait counts for little. Returns nothing if a body has no
/// wide tree or if no triangle was tested under any pose.
[[nodiscard]] std::optional<SearchCost> measure_search_cost(const TreeView& a,
                                                            const TreeView& b,
                                                            std::span<const PosePair> poses,
                                                            const SearchCostOptions& options = {});

} // namespace cd
