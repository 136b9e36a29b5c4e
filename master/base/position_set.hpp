// A set of positions in a job's hand-out order, kept as intervals.
#pragma once

#include "common/job/poses/ordered_poses.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// Operations take time proportional to the number of runs of consecutive positions, not of
/// positions. Work in flight mostly consists of a few runs.
class PositionSet {
  public:
    PositionSet() = default;
    /// Implicit, because a range is a set of positions.
    PositionSet(const PositionRange& range) { add(range); }
    /// Takes positions in any order, each at most once.
    [[nodiscard]] static PositionSet of(std::vector<std::uint64_t> positions);

    [[nodiscard]] bool is_empty() const { return runs_.empty(); }
    /// Number of positions.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] bool contains(std::uint64_t position) const;
    /// Maximal runs of consecutive positions, ascending.
    [[nodiscard]] std::span<const PositionRange> runs() const { return runs_; }
    /// All positions, ascending.
    [[nodiscard]] std::vector<std::uint64_t> list() const;
    /// The last `most` positions, or all if there are fewer.
    [[nodiscard]] PositionSet last(std::uint64_t most) const;
    [[nodiscard]] PositionSet common_with(const PositionSet& other) const;

    void add(const PositionRange& range);
    void add(const PositionSet& other);
    /// Removes the positions in the hole.
    void remove(const PositionRange& hole);
    void remove(const PositionSet& other);

    friend bool operator==(const PositionSet&, const PositionSet&) = default;

  private:
    using Runs = std::vector<PositionRange>;

    /// The first run that ends after `position`.
    [[nodiscard]] Runs::const_iterator run_after(std::uint64_t position) const;

    Runs runs_; ///< Ascending; no run is empty, and no two runs overlap or touch.
    std::uint64_t count_ = 0;
};

} // namespace cd
