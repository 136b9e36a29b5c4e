// Counts the triangles of a large node in bins, so that a split takes no sorting.
#pragma once

#include "common/tree/build/build_fit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cd {

/// Divides an interval into equal bins and maps a triangle's interval to the bin of its high end.
/// The result is rounded, but reproducible, and a higher end never falls in a lower bin.
class BinScale {
  public:
    static constexpr std::uint32_t bin_count = 16;

    explicit BinScale(const Interval& whole);

    /// Returns false if the interval is too short or too long for doubles to tell the bins apart.
    [[nodiscard]] bool is_valid() const { return factor_ > 0; }

    [[nodiscard]] std::uint32_t bin_of(const Interval& triangle) const {
        const auto bin = static_cast<std::int32_t>((triangle.high - low_) * factor_);
        return static_cast<std::uint32_t>(bin) < bin_count ? static_cast<std::uint32_t>(bin)
                                                           : bin_count - 1;
    }

  private:
    double low_;
    double factor_;
};

/// Counts the triangles of a node by the bin of their maximal projection, on each of the three
/// axes.
class Bins {
  public:
    /// A split behind bin `last_bin`, with its sum of relative segments (`SplitRule`).
    struct Candidate {
        double sum = 0;
        std::uint32_t last_bin = 0;
        std::uint32_t left_count = 0;
    };

    explicit Bins(const Projection& whole);

    void add(std::span<const Projection> triangles);
    /// Adds the counts and extents of another Bins of this node.
    Bins& operator+=(const Bins& other);

    /// Returns the split with the least sum among the splits with at least `side` triangles on each
    /// side, or nothing if there is none.
    [[nodiscard]] std::optional<Candidate> best(std::size_t axis, std::uint32_t side) const;

  private:
    struct Bin {
        Interval extent;
        std::uint32_t count = 0;
    };
    using Axis = std::array<Bin, BinScale::bin_count>;

    std::array<BinScale, 3> scales_;
    Projection whole_;
    std::array<Axis, 3> axes_;
};

} // namespace cd
