// Where to split the triangles of a node (paper, 6.2).
#pragma once

#include "common/core/thread_pool.hpp"
#include "common/tree/build.hpp"
#include "common/tree/build_fit.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cd {

/// Memory that the sweeps use again; one per axis.
struct SplitScratch {
    struct Axis {
        std::vector<std::uint64_t> order;
        std::vector<double> low_after;
    };
    std::array<Axis, 3> axes;
};

/// The triangles of the left child are the first `left_count` in the order of their maximal
/// projection on `axis`: those whose rank is at most `last_rank`.
struct Split {
    std::size_t axis = 0;
    std::uint32_t left_count = 0;
    std::uint64_t last_rank = 0;
};

/// A triangle's place in the order along an axis: the maximum of its interval within the whole,
/// then its place among the triangles. Distinct for distinct places.
[[nodiscard]] std::uint64_t
split_rank(const Interval& triangle, const Interval& whole, std::uint32_t place);

/// Nothing when no axis tells the triangles apart. The three axes run on `pool` where there is one.
[[nodiscard]] std::optional<Split> choose_split(const Projections& projections,
                                                SplitRule rule,
                                                SplitScratch& scratch,
                                                ThreadPool* pool);

} // namespace cd
