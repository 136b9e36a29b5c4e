// What the tests of a search cost on this machine: the constants of the paper's cost function.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/tree/obb_tree.hpp"

#include <chrono>
#include <optional>
#include <span>

namespace cd {

struct QueryStatistics;

/// The paper's C_b and C_p (section 3), in nanoseconds: with N_b and N_p, the numbers of tests, a
/// search costs N_b C_b + N_p C_p, but for what it does with the contacts that it finds.
struct SearchCost {
    double box_test_ns = 0;
    double triangle_test_ns = 0;

    /// N_b C_b + N_p C_p, in seconds.
    [[nodiscard]] double seconds_of(const QueryStatistics& statistics) const;

    friend bool operator==(const SearchCost&, const SearchCost&) = default;
};

struct SearchCostOptions {
    bool for_any = false; ///< Search for a first contact, as level any does, not for all.
    PairStage first_stage = PairStage::Float;
    /// After that no pose is begun but the first.
    std::chrono::steady_clock::duration time_max = std::chrono::milliseconds(50);
};

/// Searches the wide trees under one pose after another as ContactSearch does, on the calling
/// thread, with a look at the clock between the walk and the decisions. A constant is the median
/// over all tests of what one costs under its pose, so that a pose during which the thread had to
/// wait counts for little. Nothing where a body has no wide tree, or under no pose a triangle was
/// tested.
[[nodiscard]] std::optional<SearchCost> measure_search_cost(const TreeView& a,
                                                            const TreeView& b,
                                                            std::span<const PosePair> poses,
                                                            const SearchCostOptions& options = {});

} // namespace cd
