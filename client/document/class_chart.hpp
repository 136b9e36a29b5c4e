// Charts of the classes of scenarios, over the space of poses or in their order.
#pragma once

#include "client/document/html.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cd {

/// An axis of a chart: its name, and the texts at its ends.
struct ChartAxis {
    std::string name;
    std::string low;
    std::string high;
};

/// Cells of scenarios. A cell shows the worst of its classes (`severity`).
class ClassChart {
  public:
    /// Makes a strip in the order of the scenarios. `classes` are as in `RunOverview`.
    [[nodiscard]] static ClassChart strip(const std::vector<std::uint8_t>& classes);
    /// Makes a map over the two axes of a grid that have most values. `axes` are the six axes of
    /// the job for the ends, or empty. `unit` is that of lengths.
    [[nodiscard]] static ClassChart of_grid(const Grid& grid,
                                            const std::vector<GridAxis>& axes,
                                            const std::string& unit,
                                            const std::vector<std::uint8_t>& classes);
    /// Makes a map over the two of x, y and z in which B's origin in A's frame moves most. Errors:
    /// from reading poses; Interrupted.
    [[nodiscard]] static Result<ClassChart> of_poses(PoseSource& poses,
                                                     const std::string& unit,
                                                     const std::vector<std::uint8_t>& classes,
                                                     const StopCheck& stop);

    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }
    /// Draws the chart as SVG with its legend, in a document with `style_sheet`.
    [[nodiscard]] Html svg() const;
    /// Returns the style sheet of all charts.
    [[nodiscard]] static std::string style_sheet();

  private:
    ClassChart(std::size_t columns, std::size_t rows, ChartAxis across, ChartAxis up);

    void add(std::size_t column, std::size_t row, std::uint8_t kind);
    [[nodiscard]] Html cells(double width, double height) const;

    std::size_t columns_;
    std::size_t rows_; ///< Row 0 is at the bottom.
    ChartAxis across_;
    ChartAxis up_;
    std::vector<std::uint8_t> rank_; ///< Of each cell, row by row; 0: no scenario.
};

/// True if a grid has two axes with more than one value, so that a map shows more than a strip.
[[nodiscard]] bool is_plane(const Grid& grid);

} // namespace cd
