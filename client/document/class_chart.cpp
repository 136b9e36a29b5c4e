#include "client/document/class_chart.hpp"

#include "client/document/run_overview.hpp"
#include "common/core/words.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/severity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t cells_max = 96;  ///< Along an axis of a map.
constexpr std::size_t strip_max = 512; ///< Cells of a strip.
constexpr std::uint64_t origins_at_once = 1u << 16;

/// A kind of cell: how it looks, and what the legend says. Later ones are worse.
struct CellLook {
    const char* colour;
    const char* word;
};
constexpr std::array<CellLook, 10> cell_looks{{{"#ffffff", "no scenario"},
                                               {"#c4c4c4", "not tested"},
                                               {"#7fbf7f", "separate"},
                                               {"#c9a0dc", "undecided"},
                                               {"#f08c28", "near"},
                                               {"#f2d230", "touch"},
                                               {"#dc5a32", "contact"},
                                               {"#c8201e", "cross"},
                                               {"#92245c", "inside"},
                                               {"#3c4046", "failed"}}};

/// Returns the place of a class of `RunOverview::classes` in `cell_looks`.
std::uint8_t rank_of(std::uint8_t kind) {
    if (kind == RunOverview::left_out) {
        return 0;
    }
    return kind == RunOverview::no_result
               ? 1
               : static_cast<std::uint8_t>(1 + severity(static_cast<ScenarioClass>(kind)));
}

/// Returns the cell of a value, if `count` values are spread evenly over `cells` cells.
std::size_t cell_of(std::uint64_t value, std::uint64_t count, std::size_t cells) {
    return static_cast<std::size_t>(static_cast<double>(value) / static_cast<double>(count) *
                                    static_cast<double>(cells));
}

std::string number_text(double value) {
    return fmt::format("{:.4g}", value + 0.0);
}

constexpr std::array<const char*, 6> axis_names{"x", "y", "z", "roll", "pitch", "yaw"};

std::array<std::uint64_t, 6> axis_counts(const Grid& grid) {
    std::array<std::uint64_t, 6> counts{};
    for (std::size_t i = 0; i < 3; ++i) {
        counts[i] = grid.position[i].count;
        counts[i + 3] = std::max<std::uint64_t>(1, grid.rotation[i].size());
    }
    return counts;
}

/// Returns the two axes with most values, in the order x, y, z, roll, pitch, yaw.
std::array<std::size_t, 2> longest_axes(const std::array<std::uint64_t, 6>& counts) {
    std::array<std::size_t, 6> order{0, 1, 2, 3, 4, 5};
    std::ranges::stable_sort(order,
                             [&](std::size_t l, std::size_t r) { return counts[l] > counts[r]; });
    return {std::min(order[0], order[1]), std::max(order[0], order[1])};
}

ChartAxis axis_of(const Grid& grid,
                  const std::vector<GridAxis>& axes,
                  const std::string& unit,
                  std::size_t axis) {
    const std::string name = axis_names[axis];
    if (axis < 3) {
        const GridAxis& values = grid.position[axis];
        return {name + " [" + unit + "]", number_text(values.first), number_text(values.last)};
    }
    if (axis < axes.size()) {
        return {name + " [deg]", number_text(axes[axis].first), number_text(axes[axis].last)};
    }
    return {name, "first", "last"};
}

/// Calls `take` with each scenario's index and B's origin in A's frame, rounded.
template <class Take>
Status
for_each_origin(PoseSource& poses, std::uint64_t count, const StopCheck& stop, const Take& take) {
    for (std::uint64_t first = 0; first < count; first += origins_at_once) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto read = poses.read(first, std::min(origins_at_once, count - first));
        if (!read) {
            return read.error();
        }
        for (std::size_t i = 0; i < read.value().size(); ++i) {
            const PosePair& pair = read.value()[i].poses;
            const Vec3 origin =
                pair.a == Pose{} ? pair.b.translation() : relative_pose(pair).translation;
            if (origin.allFinite()) {
                take(first + i, origin);
            }
        }
    }
    return Done{};
}

Html rectangle(double x, double y, double width, double height, std::uint8_t rank) {
    return Html::element("rect",
                         Html(),
                         {{"x", fmt::format("{:.2f}", x)},
                          {"y", fmt::format("{:.2f}", y)},
                          {"width", fmt::format("{:.2f}", width)},
                          {"height", fmt::format("{:.2f}", height)},
                          {"class", "k" + std::to_string(rank)}});
}

} // namespace

ClassChart::ClassChart(std::size_t columns, std::size_t rows, ChartAxis across, ChartAxis up)
    : columns_(columns),
      rows_(rows),
      across_(std::move(across)),
      up_(std::move(up)),
      rank_(columns * rows, 0) {}

void ClassChart::add(std::size_t column, std::size_t row, std::uint8_t kind) {
    std::uint8_t& rank =
        rank_[std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1)];
    rank = std::max(rank, rank_of(kind));
}

ClassChart ClassChart::strip(const std::vector<std::uint8_t>& classes) {
    const std::size_t cells = std::clamp<std::size_t>(classes.size(), 1, strip_max);
    const std::string last = std::to_string(classes.empty() ? 0 : classes.size() - 1);
    ClassChart chart(cells, 1, {"scenarios in order", "0", last}, {});
    for (std::uint64_t i = 0; i < classes.size(); ++i) {
        chart.add(cell_of(i, classes.size(), cells), 0, classes[i]);
    }
    return chart;
}

ClassChart ClassChart::of_grid(const Grid& grid,
                               const std::vector<GridAxis>& axes,
                               const std::string& unit,
                               const std::vector<std::uint8_t>& classes) {
    const auto counts = axis_counts(grid);
    const auto [across, up] = longest_axes(counts);
    const auto cells = [&](std::size_t axis) {
        return static_cast<std::size_t>(std::min<std::uint64_t>(counts[axis], cells_max));
    };
    ClassChart chart(
        cells(across), cells(up), axis_of(grid, axes, unit, across), axis_of(grid, axes, unit, up));
    for (std::uint64_t i = 0; i < classes.size(); ++i) {
        std::array<std::uint64_t, 6> place{}; // The last axis varies fastest.
        std::uint64_t rest = i;
        for (std::size_t axis = 6; axis-- > 0;) {
            place[axis] = rest % counts[axis];
            rest /= counts[axis];
        }
        chart.add(cell_of(place[across], counts[across], chart.columns_),
                  cell_of(place[up], counts[up], chart.rows_),
                  classes[i]);
    }
    return chart;
}

Result<ClassChart> ClassChart::of_poses(PoseSource& poses,
                                        const std::string& unit,
                                        const std::vector<std::uint8_t>& classes,
                                        const StopCheck& stop) {
    Aabb box;
    const Status sized =
        for_each_origin(poses, classes.size(), stop, [&](std::uint64_t i, const Vec3& at) {
            if (classes[i] != RunOverview::left_out) {
                box.add(at);
            }
        });
    if (!sized) {
        return sized.error();
    }
    const Vec3 size = box.size();
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, [&](int l, int r) { return size[l] > size[r]; });
    const auto [across, up] = std::minmax(order[0], order[1]);
    const auto axis = [&](int k) {
        const bool is_empty = box.is_empty();
        return ChartAxis{std::string(axis_names[static_cast<std::size_t>(k)]) + " [" + unit + "]",
                         number_text(is_empty ? 0 : box.min[k]),
                         number_text(is_empty ? 0 : box.max[k])};
    };
    ClassChart chart(cells_max, cells_max, axis(across), axis(up));
    const auto cell = [&, low = box.min](const Vec3& at, int k) {
        const double share = size[k] > 0 ? (at[k] - low[k]) / size[k] : 0.5;
        return static_cast<std::size_t>(share * static_cast<double>(cells_max));
    };
    const int a = across;
    const int b = up;
    const Status filled =
        for_each_origin(poses, classes.size(), stop, [&](std::uint64_t i, const Vec3& at) {
            if (classes[i] != RunOverview::left_out) {
                chart.add(cell(at, a), cell(at, b), classes[i]);
            }
        });
    return filled ? Result<ClassChart>(std::move(chart)) : filled.error();
}

Html ClassChart::cells(double width, double height) const {
    Html cells;
    const double dx = width / static_cast<double>(columns_);
    const double dy = height / static_cast<double>(rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
        // A rectangle spans equal neighbours, so that large charts stay small files.
        for (std::size_t begin = 0; begin < columns_;) {
            const std::uint8_t rank = rank_[row * columns_ + begin];
            std::size_t end = begin + 1;
            while (end < columns_ && rank_[row * columns_ + end] == rank) {
                ++end;
            }
            if (rank != 0) {
                cells += rectangle(static_cast<double>(begin) * dx,
                                   height - static_cast<double>(row + 1) * dy,
                                   static_cast<double>(end - begin) * dx,
                                   dy,
                                   rank);
            }
            begin = end;
        }
    }
    return cells;
}

Html ClassChart::svg() const {
    constexpr double width = 640;
    const double height = rows_ == 1 ? 28 : 400;
    const Html frame = Html::element("rect",
                                     Html(),
                                     {{"x", "0"},
                                      {"y", "0"},
                                      {"width", fmt::format("{:.0f}", width)},
                                      {"height", fmt::format("{:.0f}", height)},
                                      {"fill", "none"},
                                      {"stroke", "#555"}});
    Html drawing = cells(width, height);
    drawing += frame;
    drawing += svg_text(0, height + 16, "start", across_.low);
    drawing += svg_text(width / 2, height + 16, "middle", across_.name);
    drawing += svg_text(width, height + 16, "end", across_.high);
    drawing += svg_text(-6, height, "end", up_.low);
    drawing += svg_text(-6, height / 2, "end", up_.name);
    drawing += svg_text(-6, 12, "end", up_.high);
    double x = 0;
    for (std::size_t rank = 1; rank < cell_looks.size(); ++rank) {
        if (std::ranges::find(rank_, rank) == rank_.end()) {
            continue;
        }
        drawing += rectangle(x, height + 26, 12, 12, static_cast<std::uint8_t>(rank));
        drawing += svg_text(x + 17, height + 36, "start", cell_looks[rank].word);
        x += 40 + 7.0 * static_cast<double>(std::string_view(cell_looks[rank].word).size());
    }
    return Html::element(
        "svg",
        drawing,
        {{"viewBox", fmt::format("-90 -4 {:.0f} {:.0f}", width + 110, height + 50)},
         {"role", "img"},
         {"class", "chart"}});
}

std::string ClassChart::style_sheet() {
    std::string style;
    for (std::size_t rank = 1; rank < cell_looks.size(); ++rank) {
        style += fmt::format(".k{}{{fill:{}}}", rank, cell_looks[rank].colour);
    }
    return style;
}

bool is_plane(const Grid& grid) {
    return std::ranges::count_if(axis_counts(grid), [](std::uint64_t n) { return n > 1; }) >= 2;
}

} // namespace cd
