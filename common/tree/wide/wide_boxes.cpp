#include "common/tree/wide/wide_boxes.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/wide_boxes_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace cd {

namespace {

using Axes = WideBoxes::Axes;

/// The smallest step. The largest coordinates, and sums of coordinates, stay within the range of
/// floats when counted in such steps (wide_kernel.cpp).
constexpr double step_min = 0x1p-70;
constexpr double u = 0x1p-53;

double in_row(const SeenFrame& frame, std::size_t k, const std::array<double, 3>& v) {
    return frame.rows[3 * k] * v[0] + frame.rows[3 * k + 1] * v[1] + frame.rows[3 * k + 2] * v[2];
}

Spread united(const Spread& left, const Spread& right) {
    Spread both = left;
    for (std::size_t k = 0; k < 3; ++k) {
        both.low[k] = std::min(left.low[k], right.low[k]);
        both.high[k] = std::max(left.high[k], right.high[k]);
    }
    both.reach = std::max(left.reach, right.reach);
    return both;
}

/// Sets the node's steps, frame and origin for vertices with this spread. Returns the conversion
/// from coordinates in `frame` to steps.
///
/// A vertex's coordinates err by at most 6 u times the sum of the vertex's distances from the
/// centre (one subtraction, three products, two sums, entries of at most 1.001). The coordinates of
/// the node's origin err by at most 6 u times the sum of the origin's distances, for the same
/// reason. `StepAxis::error` covers both errors.
std::array<StepAxis, 3>
set_frame(const Spread& whole, const SeenFrame& frame, bool float_origin, WideNode& node) {
    double largest = 0;
    double size = whole.reach;
    for (std::size_t k = 0; k < 3; ++k) {
        largest = std::max(largest, whole.high[k] - whole.low[k]);
        size = std::max(size, std::abs(frame.center[k]));
    }
    // A quarter of a step exceeds all roundings of the origin.
    const double least = std::max((float_origin ? 0x1p-18 : 0x1p-44) * size, step_min);
    std::array<double, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
        // A lower bound on the extent keeps quotients of steps bounded.
        const double extent = std::max(whole.high[k] - whole.low[k], 0x1p-10 * largest);
        const double step = std::max(extent / 254, least);
        node.steps[k] = static_cast<float>(step * (1 + 0x1p-20));
        corner[k] = whole.low[k] - 0.25 * static_cast<double>(node.steps[k]);
        for (std::size_t c = 0; c < 3; ++c) {
            node.columns[c][k] = static_cast<float>(frame.rows[3 * k + c]);
        }
    }
    node.steps[3] = 1;
    std::array<double, 3> from_center{};
    for (std::size_t c = 0; c < 3; ++c) {
        double& origin = node.origin[c];
        origin = frame.center[c];
        for (std::size_t k = 0; k < 3; ++k) {
            origin += frame.rows[3 * k + c] * corner[k];
        }
        if (float_origin) {
            origin = static_cast<double>(static_cast<float>(origin));
        }
        from_center[c] = origin - frame.center[c];
    }
    const double distance =
        std::abs(from_center[0]) + std::abs(from_center[1]) + std::abs(from_center[2]);
    std::array<StepAxis, 3> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        axes[k] = {in_row(frame, k, from_center),
                   16 * u * (whole.reach + distance),
                   static_cast<double>(node.steps[k])};
        // A product of a step and a byte is exact in doubles.
        CD_CHECK(whole.low[k] - axes[k].origin - axes[k].error >= 0);
        CD_CHECK(whole.high[k] - axes[k].origin + axes[k].error <= 255 * axes[k].step);
    }
    return axes;
}

SeenFrame seen_from(const TriangleBlocks& blocks, std::uint32_t vertex, const Axes& axes) {
    SeenFrame frame;
    std::copy(axes.begin(), axes.end(), frame.rows.begin());
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t at = 3 * std::size_t{vertex} + k;
        frame.center[k] =
            blocks.doubles.empty() ? static_cast<double>(blocks.floats[at]) : blocks.doubles[at];
    }
    return frame;
}

} // namespace

WideBoxes::WideBoxes(const TriangleBlocks& blocks, std::span<const WideNode> nodes)
    : blocks_(blocks), nodes_(nodes), vertices_(nodes.size()) {
    for (std::size_t i = nodes.size(); i-- > 0;) {
        const WideNode& node = nodes[i];
        if (node.is_leaf) {
            vertices_[i] = {blocks.vertex_begin[node.first], blocks.vertex_begin[node.first + 1]};
            continue;
        }
        vertices_[i] = vertices_[node.first];
        for (std::uint32_t child = 1; child < node.count; ++child) {
            const Run& run = vertices_[node.first + child];
            vertices_[i].begin = std::min(vertices_[i].begin, run.begin);
            vertices_[i].end = std::max(vertices_[i].end, run.end);
        }
    }
}

WideNode WideBoxes::in_frame(std::size_t index, const Axes& axes) const {
    WideNode node;
    node.first = nodes_[index].first;
    node.count = nodes_[index].count;
    node.is_leaf = nodes_[index].is_leaf;
    const Run& own = vertices_[index];
    const SeenFrame frame = seen_from(blocks_, own.begin, axes);
    if (node.is_leaf) {
        BlockCoordinates coordinates;
        const Spread whole = spread_of(blocks_, own.begin, own.end, frame, &coordinates);
        set_triangle_boxes(coordinates,
                           own.end - own.begin,
                           &blocks_.corners[std::size_t{block_size} * node.first],
                           set_frame(whole, frame, blocks_.doubles.empty(), node),
                           node);
        return node;
    }
    ChildSpreads spreads;
    Spread whole;
    for (std::size_t i = 0; i < node.count; ++i) {
        const Run& run = vertices_[node.first + i];
        const Spread child = spread_of(blocks_, run.begin, run.end, frame);
        whole = i == 0 ? child : united(whole, child);
        for (std::size_t k = 0; k < 3; ++k) {
            spreads.low[k][i] = child.low[k];
            spreads.high[k][i] = child.high[k];
        }
    }
    set_child_boxes(spreads, set_frame(whole, frame, false, node), node);
    return node;
}

double cost_of(const WideNode& node) {
    double sum = 0;
    for (std::size_t i = 0; i < node.count; ++i) {
        std::array<double, 3> size{};
        for (std::size_t k = 0; k < 3; ++k) {
            size[k] = static_cast<double>(node.steps[k]) * (node.high[k][i] - node.low[k][i]);
        }
        sum += size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
    return sum;
}

double extent_of(std::span<const WideNode> nodes) {
    double extent = 0;
    for (const WideNode& node : nodes) {
        for (const double coordinate : node.origin) {
            extent = std::max(extent, std::abs(coordinate));
        }
    }
    return extent;
}

} // namespace cd
