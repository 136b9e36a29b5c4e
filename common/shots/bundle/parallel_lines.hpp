// Lines that are parallel to an axis of their body, in bins of the plane across it.
#pragma once

#include "common/shots/line_hit.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The coordinates of lines on one axis across, by column or row of bins.
struct LineSteps {
    double bins_per_length = 0; ///< 0 where all lines have one coordinate.
    std::vector<double> least;  ///< Of each column or row; infinite without lines.
    std::vector<double> most;   ///< Of each column or row; minus infinite without lines.
    /// The same relative to the lines' middle, rounded outwards.
    std::vector<float> least_from_middle;
    std::vector<float> most_from_middle;
    /// Of a grid: times the distance of a coordinate from the first one, this is the number of the
    /// column or row at it, within `slack`. Doubles compute it so, and it never falls.
    double steps_per_length = 1;
    double slack = 0;

    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(least.size()); }
};

/// Lines in the order of their bins, row by row.
struct LineRows {
    /// Each line's coordinates across, followed by `ParallelLines::spare_lines` meaningless
    /// numbers.
    std::array<const double*, 2> across;
    /// The number of the first line of each bin, by row and column; the last entry is their count.
    const std::uint32_t* begins;
    std::uint32_t columns;

    [[nodiscard]] std::uint32_t begin_of(std::uint32_t column, std::uint32_t row) const {
        return begins[std::size_t{row} * columns + column];
    }
};

/// Lines from p to q that differ only in the two coordinates across their axis. Bins form a grid of
/// about as many cells as there are lines. Coordinates across are those of the axes `axis` + 1 and
/// `axis` + 2, modulo 3; below, the first selects the column and the second the row.
class ParallelLines {
  public:
    /// Count of numbers that may be read past the last line.
    static constexpr std::size_t spare_lines = 8;

    /// Takes the lines of a body's triangles (p, q, q). Returns false if these are not parallel to
    /// one axis, or begin or end at different places of it; nothing else may be called then.
    [[nodiscard]] bool assign(const WideView& bundle);

    [[nodiscard]] std::size_t axis() const { return axis_; }
    /// Returns the coordinates of p and q along the axis; they differ.
    [[nodiscard]] const std::array<double, 2>& ends() const { return ends_; }
    /// Returns the box of the lines across the axis.
    [[nodiscard]] const std::array<double, 2>& least() const { return least_; }
    [[nodiscard]] const std::array<double, 2>& most() const { return most_; }
    [[nodiscard]] std::array<double, 2> middle() const {
        return {least_[0] + 0.5 * (most_[0] - least_[0]), least_[1] + 0.5 * (most_[1] - least_[1])};
    }
    /// Bounds the distances of lines from the middle, along each axis.
    [[nodiscard]] std::array<float, 2> half() const {
        const auto half = [this](std::size_t which) {
            return static_cast<float>(0.51 * (most_[which] - least_[which]) +
                                      0x1p-40 * std::abs(most_[which] + least_[which]));
        };
        return {half(0), half(1)};
    }

    /// Bounds the size of a bin.
    [[nodiscard]] double bin_size(std::size_t which) const {
        const double per_length = steps_[which].bins_per_length;
        return per_length > 0 ? 1.01 / per_length : most_[which] - least_[which];
    }
    /// Returns the column or row of a coordinate, the nearest one if it is beyond all. Never falls
    /// as x grows, so that the bins of two numbers hold all lines between them.
    [[nodiscard]] std::uint32_t bin_of(double x, std::size_t which) const {
        const LineSteps& steps = steps_[which];
        const double place = (x - least_[which]) * steps.bins_per_length;
        const auto last = static_cast<double>(steps.count() - 1);
        return static_cast<std::uint32_t>(std::min(std::max(place, 0.0), last));
    }
    /// Returns whether the lines are those of a grid, all columns times all rows, each evenly
    /// spaced. Then each bin has one line, and a box whose two intervals hold coordinates of lines
    /// holds a line.
    [[nodiscard]] bool is_grid() const { return is_grid_; }
    /// Returns whether a box across the axis may hold a line. Looks only into few
    /// bins, and returns true for a box of many.
    [[nodiscard]] bool may_hold(const std::array<double, 2>& low,
                                const std::array<double, 2>& high) const;
    /// Returns the coordinates that the columns or rows hold.
    [[nodiscard]] const LineSteps& steps(std::size_t which) const { return steps_[which]; }
    /// Returns the lines, in the order of their bins.
    [[nodiscard]] LineRows rows() const {
        return {{across_[0].data(), across_[1].data()}, begins_.data(), steps_[0].count()};
    }
    /// Returns each line's slot in the body's blocks.
    [[nodiscard]] std::span<const std::uint32_t> slots() const { return slots_; }

  private:
    [[nodiscard]] bool add(const Segment& line, std::uint32_t slot);
    [[nodiscard]] std::size_t distinct(std::size_t which) const;
    void choose_bins();
    void sort_into_bins();
    void note_steps();

    std::size_t axis_ = 0;
    std::array<double, 2> ends_{};
    std::array<double, 2> least_{};
    std::array<double, 2> most_{};
    std::array<LineSteps, 2> steps_; ///< Of columns and rows.
    bool is_grid_ = false;
    std::vector<std::uint32_t> begins_;
    std::array<std::vector<double>, 2> across_;
    std::vector<std::uint32_t> slots_;

    struct Unsorted {
        std::array<double, 2> across;
        std::uint32_t slot;
        std::uint32_t bin;
    };
    std::vector<Unsorted> unsorted_; ///< Scratch memory: the lines in the order of the blocks.
};

} // namespace cd
