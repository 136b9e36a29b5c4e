#include "common/shots/bundle/parallel_lines.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace cd {

namespace {

/// Boxes of more columns and rows than this hold a line nearly always.
constexpr std::uint32_t looked_at_most = 3;

/// Columns and rows that differ by more from even ones are no grid.
constexpr double slack_most = 0x1p-6;

/// Returns the only axis along which a line's ends differ; nothing if there are none or several.
std::optional<std::size_t> axis_of(const Segment& line) {
    std::optional<std::size_t> axis;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        if (line.p[i] != line.q[i]) {
            if (axis) {
                return std::nullopt;
            }
            axis = k;
        }
    }
    return axis;
}

/// Measures the spacing of a grid's columns or rows. Returns false if they are not even.
bool note_spacing(LineSteps& steps) {
    const std::size_t last = steps.least.size() - 1;
    const double size = steps.least[last] - steps.least[0];
    // A large factor tells coordinates from that of a single column.
    steps.steps_per_length = last == 0 ? 0x1p20 : static_cast<double>(last) / size;
    steps.slack = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const double place = (steps.least[i] - steps.least[0]) * steps.steps_per_length;
        steps.slack = std::max(steps.slack, std::abs(place - static_cast<double>(i)));
    }
    return std::isfinite(steps.steps_per_length) && steps.slack < slack_most;
}

} // namespace

bool ParallelLines::assign(const WideView& bundle) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    unsorted_.clear();
    least_ = {infinity, infinity};
    most_ = {-infinity, -infinity};
    const TriangleBlocks& blocks = bundle.triangles;
    for (const WideNode& node : bundle.nodes) {
        for (std::uint32_t i = 0; node.is_leaf && i < node.count; ++i) {
            const std::uint32_t slot = block_size * node.first + i;
            const std::size_t vertices = blocks.vertex_begin[node.first];
            const BlockCorners& corners = blocks.corners[slot];
            const Segment line{blocks.vertex(vertices + corners[0]),
                               blocks.vertex(vertices + corners[1])};
            const bool is_line =
                corners[1] == corners[2] || blocks.vertex(vertices + corners[2]) == line.q;
            if (!is_line || !add(line, slot)) {
                return false;
            }
        }
    }
    if (unsorted_.empty()) {
        return false;
    }
    choose_bins();
    sort_into_bins();
    note_steps();
    return true;
}

/// Adds a line if it is parallel to those before it, and has the same ends along the axis.
bool ParallelLines::add(const Segment& line, std::uint32_t slot) {
    if (unsorted_.empty()) {
        const std::optional<std::size_t> axis = axis_of(line);
        if (!axis) {
            return false;
        }
        axis_ = *axis;
        const auto along = static_cast<Eigen::Index>(axis_);
        ends_ = {line.p[along], line.q[along]};
    }
    const auto along = static_cast<Eigen::Index>(axis_);
    if (line.p[along] != ends_[0] || line.q[along] != ends_[1]) {
        return false;
    }
    Unsorted made{{}, slot, 0};
    for (std::size_t which = 0; which < 2; ++which) {
        const auto axis = static_cast<Eigen::Index>((axis_ + 1 + which) % 3);
        if (line.p[axis] != line.q[axis]) {
            return false;
        }
        made.across[which] = line.p[axis];
        least_[which] = std::min(least_[which], line.p[axis]);
        most_[which] = std::max(most_[which], line.p[axis]);
    }
    unsorted_.push_back(made);
    return true;
}

/// Returns the number of the lines' coordinates on an axis across.
std::size_t ParallelLines::distinct(std::size_t which) const {
    std::vector<double> coordinates;
    coordinates.reserve(unsorted_.size());
    for (const Unsorted& line : unsorted_) {
        coordinates.push_back(line.across[which]);
    }
    std::ranges::sort(coordinates);
    const auto repeated = std::ranges::unique(coordinates);
    return coordinates.size() - repeated.size();
}

/// Chooses the columns and rows of a grid; else cells that are about as wide as high, one a line.
void ParallelLines::choose_bins() {
    const auto lines = static_cast<double>(unsorted_.size());
    const std::array<double, 2> size{most_[0] - least_[0], most_[1] - least_[1]};
    const std::array<std::size_t, 2> distinct{this->distinct(0), this->distinct(1)};
    std::array<double, 2> counts{1, 1};
    if (distinct[0] * distinct[1] == unsorted_.size()) {
        counts = {static_cast<double>(distinct[0]), static_cast<double>(distinct[1])};
    } else if (size[0] > 0 && size[1] > 0) {
        counts[0] = std::clamp(std::round(std::sqrt(lines * (size[0] / size[1]))), 1.0, lines);
        counts[1] = std::ceil(lines / counts[0]);
    } else {
        counts = {size[0] > 0 ? lines : 1, size[1] > 0 ? lines : 1};
    }
    for (std::size_t which = 0; which < 2; ++which) {
        const double per_length = size[which] > 0 ? counts[which] / size[which] : 0;
        steps_[which].bins_per_length = std::isfinite(per_length) ? per_length : 0;
        const auto count = static_cast<std::size_t>(counts[which]);
        steps_[which].least.assign(count, std::numeric_limits<double>::infinity());
        steps_[which].most.assign(count, -std::numeric_limits<double>::infinity());
    }
}

void ParallelLines::sort_into_bins() {
    const std::size_t bins = std::size_t{steps_[0].count()} * steps_[1].count();
    begins_.assign(bins + 1, 0);
    for (Unsorted& line : unsorted_) {
        const std::array bins_of_line{bin_of(line.across[0], 0), bin_of(line.across[1], 1)};
        for (std::size_t which = 0; which < 2; ++which) {
            double& least = steps_[which].least[bins_of_line[which]];
            double& most = steps_[which].most[bins_of_line[which]];
            least = std::min(least, line.across[which]);
            most = std::max(most, line.across[which]);
        }
        line.bin = bins_of_line[1] * steps_[0].count() + bins_of_line[0];
        ++begins_[line.bin];
    }
    std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), 0u);
    slots_.resize(unsorted_.size());
    for (std::vector<double>& across : across_) {
        across.assign(unsorted_.size() + spare_lines, 0);
    }
    // Placing a line advances the begin of its bin, which so ends as the begin of the next bin.
    for (const Unsorted& line : unsorted_) {
        const std::uint32_t place = begins_[line.bin]++;
        across_[0][place] = line.across[0];
        across_[1][place] = line.across[1];
        slots_[place] = line.slot;
    }
    std::copy_backward(begins_.begin(), begins_.end() - 1, begins_.end());
    begins_.front() = 0;
}

void ParallelLines::note_steps() {
    const std::array<double, 2> middle = this->middle();
    // In a grid each bin has exactly one line, so the line and its bin have the same number.
    is_grid_ = std::ranges::adjacent_find(begins_, [](std::uint32_t begin, std::uint32_t end) {
                   return end - begin != 1;
               }) == begins_.end();
    for (std::size_t which = 0; which < 2; ++which) {
        LineSteps& steps = steps_[which];
        steps.least_from_middle.resize(steps.least.size());
        steps.most_from_middle.resize(steps.most.size());
        for (std::size_t i = 0; i < steps.least.size(); ++i) {
            // The margin covers the rounding of the difference and that to a float.
            const double least = steps.least[i] - middle[which];
            const double most = steps.most[i] - middle[which];
            const double margin = 0x1p-22 * half()[which];
            is_grid_ = is_grid_ && steps.least[i] == steps.most[i];
            steps.least_from_middle[i] = static_cast<float>(least - margin);
            steps.most_from_middle[i] = static_cast<float>(most + margin);
        }
        is_grid_ = is_grid_ && note_spacing(steps);
    }
}

bool ParallelLines::may_hold(const std::array<double, 2>& low,
                             const std::array<double, 2>& high) const {
    std::array<std::uint32_t, 2> first{};
    std::array<std::uint32_t, 2> last{};
    for (std::size_t which = 0; which < 2; ++which) {
        first[which] = bin_of(low[which], which);
        last[which] = bin_of(high[which], which);
    }
    if (std::min(last[0] - first[0], last[1] - first[1]) >= looked_at_most) {
        return true;
    }
    const LineRows lines = rows();
    for (std::uint32_t row = first[1]; row <= last[1]; ++row) {
        const std::uint32_t end = lines.begin_of(last[0] + 1, row);
        for (std::uint32_t i = lines.begin_of(first[0], row); i < end; ++i) {
            const double x = across_[0][i];
            const double y = across_[1][i];
            if (x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1]) {
                return true;
            }
        }
    }
    return false;
}

} // namespace cd
