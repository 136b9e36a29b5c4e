#include "common/tree/wide_tree.hpp"

#include "common/core/check.hpp"
#include "common/tree/build_fit.hpp"
#include "common/tree/wide_collapse.hpp"
#include "common/tree/wide_leaves.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace cd {

namespace {

using Axes = std::array<float, 9>; ///< Three rows.

/// Coordinates and the whole tree's size are between these, with room for products of floats.
constexpr double size_max = 0x1p50;
constexpr double size_min = 0x1p-40;
/// No step is smaller: the largest sizes stay floats when they are counted in such steps, with room
/// for sums (wide_kernel.cpp).
constexpr double step_min = 0x1p-70;
constexpr double u = 0x1p-53;

/// The least and greatest coordinate of a child on each axis of a frame, as seen from a point.
using Box = std::array<Interval, 3>;

double surface(const Box& box) {
    const double x = box[0].high - box[0].low;
    const double y = box[1].high - box[1].low;
    const double z = box[2].high - box[2].low;
    return x * y + y * z + z * x;
}

Vec3 in_frame(const Axes& axes, const Vec3& v) {
    const auto row = [&](std::size_t k) {
        return static_cast<double>(axes[k]) * v.x() + static_cast<double>(axes[k + 1]) * v.y() +
               static_cast<double>(axes[k + 2]) * v.z();
    };
    return {row(0), row(3), row(6)};
}

/// Boxes of a node's children in one frame, as seen from a point.
struct Fit {
    Axes axes{};
    Vec3 center = Vec3::Zero();
    std::vector<Box> boxes;
    double reach = 0; ///< No corner is farther from the point, by the sum of coordinates' sizes.

    [[nodiscard]] double cost() const {
        double sum = 0;
        for (const Box& box : boxes) {
            sum += surface(box);
        }
        return sum;
    }
};

/// The frames fitted to the triangles of each leaf.
std::vector<Axes> leaf_axes(const TreeView& tree, const WideLeaves& leaves) {
    std::vector<Moments> moments;
    moments.reserve(leaves.leaves.size());
    std::vector<BuildTriangle> triangles;
    for (const WideLeaf& leaf : leaves.leaves) {
        triangles.clear();
        for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
            triangles.push_back({tree.triangles[leaves.order[i]], 0});
        }
        const Vec3& origin = tree.vertices[triangles.front().vertices[0]];
        moments.push_back(sum_moments(triangles, tree.vertices, origin));
    }
    return fit_axes(moments);
}

/// Makes the nodes of a plan.
class Maker {
  public:
    Maker(const TreeView& tree,
          const WideLeaves& leaves,
          std::span<const WidePlanNode> plan,
          bool has_floats)
        : tree_(tree),
          leaves_(leaves),
          plan_(plan),
          leaf_axes_(leaf_axes(tree, leaves)),
          has_floats_(has_floats) {}

    /// All but a leaf's `first`. For any number of threads at once.
    [[nodiscard]] WideNode make(const WidePlanNode& planned) const;

  private:
    struct Range {
        std::uint32_t begin;
        std::uint32_t end;
    };

    [[nodiscard]] std::vector<Range> children_of(const WidePlanNode& planned) const;
    [[nodiscard]] Fit
    fit(const Axes& axes, const Vec3& center, std::span<const Range> children) const;

    const TreeView& tree_;
    const WideLeaves& leaves_;
    std::span<const WidePlanNode> plan_;
    std::vector<Axes> leaf_axes_;
    bool has_floats_;
};

std::vector<Maker::Range> Maker::children_of(const WidePlanNode& planned) const {
    std::vector<Range> children;
    for (std::uint32_t i = planned.begin; planned.is_leaf() && i < planned.end; ++i) {
        children.push_back({i, i + 1});
    }
    for (std::uint32_t i = 0; i < planned.count; ++i) {
        const WidePlanNode& child = plan_[planned.first + i];
        children.push_back({child.begin, child.end});
    }
    return children;
}

Fit Maker::fit(const Axes& axes, const Vec3& center, std::span<const Range> children) const {
    Fit fit{axes, center, {}, 0};
    fit.boxes.reserve(children.size());
    for (const Range& range : children) {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
        Vec3 high = -low;
        for (std::uint32_t i = range.begin; i < range.end; ++i) {
            for (const std::uint32_t vertex : tree_.triangles[leaves_.order[i]]) {
                const Vec3 from_center = tree_.vertices[vertex] - center;
                const Vec3 place = in_frame(axes, from_center);
                low = low.cwiseMin(place);
                high = high.cwiseMax(place);
                fit.reach = std::max(fit.reach, from_center.cwiseAbs().sum());
            }
        }
        fit.boxes.push_back({{{low.x(), high.x()}, {low.y(), high.y()}, {low.z(), high.z()}}});
    }
    return fit;
}

/// The steps and the origin, and each box in steps, rounded outwards.
///
/// A corner's coordinates as seen from the centre err by at most 6 u times the sum of its distances
/// (one subtraction, three products, two sums, entries of at most 1.001). The origin's own are
/// known as well. Steps times a byte are exact in doubles.
void quantise(const Fit& fit, bool float_origin, WideNode& node) {
    Box whole = fit.boxes.front();
    for (const Box& box : fit.boxes) {
        for (std::size_t k = 0; k < 3; ++k) {
            whole[k] = {std::min(whole[k].low, box[k].low), std::max(whole[k].high, box[k].high)};
        }
    }
    double largest = 0;
    for (const Interval& interval : whole) {
        largest = std::max(largest, interval.high - interval.low);
    }
    // A quarter of a step is more than all roundings of the origin.
    const double size = std::max(fit.reach, fit.center.cwiseAbs().maxCoeff());
    const double least = std::max((float_origin ? 0x1p-18 : 0x1p-44) * size, step_min);
    Vec3 corner;
    for (std::size_t k = 0; k < 3; ++k) {
        // No step is so small that quotients of steps grow out of bounds.
        const double extent = std::max(whole[k].high - whole[k].low, 0x1p-10 * largest);
        const double step = std::max(extent / 254, least);
        node.steps[k] = static_cast<float>(step * (1 + 0x1p-20));
        corner[static_cast<int>(k)] = whole[k].low - 0.25 * static_cast<double>(node.steps[k]);
        for (std::size_t c = 0; c < 3; ++c) {
            node.columns[c][k] = fit.axes[3 * k + c];
        }
    }
    Vec3 origin = fit.center;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t k = 0; k < 3; ++k) {
            origin[static_cast<int>(c)] +=
                static_cast<double>(fit.axes[3 * k + c]) * corner[static_cast<int>(k)];
        }
        if (float_origin) {
            origin[static_cast<int>(c)] =
                static_cast<double>(static_cast<float>(origin[static_cast<int>(c)]));
        }
        node.origin[c] = origin[static_cast<int>(c)];
    }
    const Vec3 from_center = origin - fit.center;
    const Vec3 place = in_frame(fit.axes, from_center);
    const double error = 16 * u * (fit.reach + from_center.cwiseAbs().sum());
    for (std::size_t i = 0; i < fit.boxes.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double step = static_cast<double>(node.steps[k]);
            const double low = fit.boxes[i][k].low - place[static_cast<int>(k)] - error;
            const double high = fit.boxes[i][k].high - place[static_cast<int>(k)] + error;
            double from = std::floor(low / step);
            from -= from * step > low ? 1 : 0;
            double to = std::ceil(high / step);
            to += to * step < high ? 1 : 0;
            CD_CHECK(from >= 0 && to <= 255);
            node.low[k][i] = static_cast<std::uint8_t>(from);
            node.high[k][i] = static_cast<std::uint8_t>(to);
        }
    }
    node.steps[3] = 1;
    node.count = static_cast<std::uint8_t>(fit.boxes.size());
}

/// In its own frame, or in the body's where the children's boxes are smaller there.
WideNode Maker::make(const WidePlanNode& planned) const {
    const std::vector<Range> children = children_of(planned);
    const Vec3 center = tree_.vertices[tree_.triangles[leaves_.order[planned.begin]][0]];
    const Axes& own =
        planned.is_leaf() ? leaf_axes_[planned.first] : tree_.nodes[planned.binary].axes;
    Fit best = fit(own, center, children);
    if (best.axes != body_axes) {
        Fit other = fit(body_axes, center, children);
        if (other.cost() < 1.001 * best.cost()) {
            best = std::move(other);
        }
    }
    WideNode node;
    quantise(best, has_floats_ && planned.is_leaf(), node);
    node.is_leaf = planned.is_leaf();
    node.first = planned.first;
    return node;
}

bool is_suitable(const TreeView& tree) {
    double reach = 0;
    Vec3 low = tree.vertices.front();
    Vec3 high = low;
    for (const Vec3& vertex : tree.vertices) {
        reach = std::max(reach, vertex.cwiseAbs().maxCoeff());
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const bool has_small_leaves = std::ranges::all_of(tree.nodes, [](const ObbNode& node) {
        return !node.is_leaf() || node.triangle_count() <= block_size * block_size;
    });
    return has_small_leaves && reach < size_max && (high - low).maxCoeff() > size_min;
}

Precision precision_of(std::span<const Vec3> vertices) {
    const bool are_floats = std::ranges::all_of(
        vertices, [](const Vec3& vertex) { return vertex.cast<float>().cast<double>() == vertex; });
    return are_floats ? Precision::Float : Precision::Double;
}

} // namespace

WideTree::WideTree(const TreeView& binary) : triangles_(precision_of(binary.vertices)) {
    if (!is_suitable(binary)) {
        return;
    }
    const WideLeaves leaves = make_wide_leaves(binary);
    const std::vector<WidePlanNode> plan = plan_wide_tree(binary, leaves);
    const Maker maker(binary, leaves, plan, !triangles_.view().floats.empty());
    nodes_.resize(plan.size());
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        nodes_[i] = maker.make(plan[i]);
        if (plan[i].is_leaf()) {
            triangles.clear();
            ids.clear();
            for (std::uint32_t k = plan[i].begin; k < plan[i].end; ++k) {
                triangles.push_back(binary.triangles[leaves.order[k]]);
                ids.push_back(binary.triangle_ids[leaves.order[k]]);
            }
            nodes_[i].first = triangles_.add(triangles, ids, binary.vertices);
        }
        for (const double coordinate : nodes_[i].origin) {
            extent_ = std::max(extent_, std::abs(coordinate));
        }
    }
    triangles_.shrink();
}

std::uint64_t WideTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(WideNode) + triangles_.memory_bytes();
}

} // namespace cd
