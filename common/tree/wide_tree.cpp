#include "common/tree/wide_tree.hpp"

#include "common/core/check.hpp"
#include "common/tree/build_fit.hpp"
#include "common/tree/wide_blocks.hpp"
#include "common/tree/wide_collapse.hpp"
#include "common/tree/wide_leaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
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
    explicit Fit(const Axes& frame) : axes(frame) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        boxes.fill({{{infinity, -infinity}, {infinity, -infinity}, {infinity, -infinity}}});
    }

    void add(std::size_t child, const Vec3& place) {
        for (std::size_t k = 0; k < 3; ++k) {
            Interval& box = boxes[child][k];
            box.low = std::min(box.low, place[static_cast<int>(k)]);
            box.high = std::max(box.high, place[static_cast<int>(k)]);
        }
    }

    [[nodiscard]] double cost(std::size_t children) const {
        double sum = 0;
        for (std::size_t i = 0; i < children; ++i) {
            sum += surface(boxes[i]);
        }
        return sum;
    }

    Axes axes;
    std::array<Box, wide_children_max> boxes{};
};

/// A node's children in its own frame and in the body's.
struct Fits {
    explicit Fits(const Axes& frame) : own(frame) {}

    Fit own;
    Fit body{body_axes};
    Vec3 center = Vec3::Zero();
    double reach = 0; ///< No corner is farther from it, by the sum of coordinates' sizes.
    std::size_t children = 0;
};

/// The vertices of one block, as doubles.
class BlockVertices {
  public:
    BlockVertices(const TriangleBlocks& blocks, std::uint32_t block) {
        const std::size_t first = blocks.vertex_begin[block];
        count_ = blocks.vertex_begin[block + 1] - first;
        for (std::size_t i = 0; i < count_; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t at = 3 * (first + i) + k;
                vertices_[i][static_cast<int>(k)] = blocks.doubles.empty()
                                                        ? static_cast<double>(blocks.floats[at])
                                                        : blocks.doubles[at];
            }
        }
    }

    [[nodiscard]] std::span<const Vec3> all() const { return std::span(vertices_).first(count_); }
    const Vec3& operator[](std::size_t i) const { return vertices_[i]; }

  private:
    static constexpr std::size_t vertices_max = 3 * block_size;

    std::size_t count_ = 0;
    std::array<Vec3, vertices_max> vertices_;
};

/// Makes the nodes of a plan.
class Maker {
  public:
    /// `block_of_leaf` by the number of a leaf; leaves stand from left to right.
    Maker(const TreeView& tree,
          const WideLeaves& leaves,
          std::span<const WidePlanNode> plan,
          std::span<const std::uint32_t> block_of_leaf,
          const TriangleBlocks& blocks)
        : tree_(tree),
          leaves_(leaves),
          plan_(plan),
          block_of_leaf_(block_of_leaf),
          blocks_(blocks) {}

    /// The nodes from `begin` to `end` of the plan. For any number of threads at once.
    void make(std::size_t begin, std::span<WideNode> nodes) const;

  private:
    [[nodiscard]] std::uint32_t block_of(const WidePlanNode& leaf) const {
        return block_of_leaf_[leaf.first];
    }
    [[nodiscard]] Moments leaf_moments(const WidePlanNode& leaf) const;
    [[nodiscard]] Fits fit_leaf(const WidePlanNode& leaf, const Axes& axes) const;
    [[nodiscard]] Fits fit_inner(const WidePlanNode& inner) const;
    void fit_child(std::size_t child, const WidePlanNode& planned, Fits& fits) const;

    const TreeView& tree_;
    const WideLeaves& leaves_;
    std::span<const WidePlanNode> plan_;
    std::span<const std::uint32_t> block_of_leaf_;
    TriangleBlocks blocks_;
};

Moments Maker::leaf_moments(const WidePlanNode& leaf) const {
    const std::uint32_t block = block_of(leaf);
    const BlockVertices vertices(blocks_, block);
    std::array<BuildTriangle, block_size> triangles;
    const std::size_t count = leaf.end - leaf.begin;
    for (std::size_t i = 0; i < count; ++i) {
        const BlockCorners& corners = blocks_.corners[std::size_t{block_size} * block + i];
        triangles[i].vertices = {corners[0], corners[1], corners[2]};
    }
    return sum_moments(std::span(triangles).first(count), vertices.all(), vertices[0]);
}

Fits Maker::fit_leaf(const WidePlanNode& leaf, const Axes& axes) const {
    const std::uint32_t block = block_of(leaf);
    const BlockVertices vertices(blocks_, block);
    Fits fits(axes);
    fits.center = vertices[0];
    fits.children = leaf.end - leaf.begin;
    for (std::size_t i = 0; i < fits.children; ++i) {
        const BlockCorners& corners = blocks_.corners[std::size_t{block_size} * block + i];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 from_center = vertices[corners[k]] - fits.center;
            fits.own.add(i, in_frame(axes, from_center));
            fits.body.add(i, from_center);
            fits.reach = std::max(fits.reach, from_center.cwiseAbs().sum());
        }
    }
    return fits;
}

/// Each vertex of a block once, instead of once for each triangle that has it.
void Maker::fit_child(std::size_t child, const WidePlanNode& planned, Fits& fits) const {
    const auto first = std::ranges::lower_bound(
        leaves_.leaves, planned.begin, std::ranges::less(), &WideLeaf::begin);
    for (auto leaf = first; leaf != leaves_.leaves.end() && leaf->begin < planned.end; ++leaf) {
        const auto number = static_cast<std::size_t>(leaf - leaves_.leaves.begin());
        const BlockVertices vertices(blocks_, block_of_leaf_[number]);
        for (const Vec3& vertex : vertices.all()) {
            const Vec3 from_center = vertex - fits.center;
            fits.own.add(child, in_frame(fits.own.axes, from_center));
            fits.body.add(child, from_center);
            fits.reach = std::max(fits.reach, from_center.cwiseAbs().sum());
        }
    }
}

Fits Maker::fit_inner(const WidePlanNode& inner) const {
    Fits fits(tree_.nodes[inner.binary].axes);
    fits.center = tree_.vertices[tree_.triangles[leaves_.order[inner.begin]][0]];
    fits.children = inner.count;
    for (std::uint32_t i = 0; i < inner.count; ++i) {
        fit_child(i, plan_[inner.first + i], fits);
    }
    return fits;
}

/// The steps and the origin, and each box in steps, rounded outwards.
///
/// A corner's coordinates as seen from the centre err by at most 6 u times the sum of its distances
/// (one subtraction, three products, two sums, entries of at most 1.001). The origin's own are
/// known as well. Steps times a byte are exact in doubles.
void quantise(const Fits& fits, const Fit& fit, bool float_origin, WideNode& node) {
    const std::span<const Box> boxes = std::span(fit.boxes).first(fits.children);
    Box whole = boxes.front();
    for (const Box& box : boxes) {
        for (std::size_t k = 0; k < 3; ++k) {
            whole[k] = {std::min(whole[k].low, box[k].low), std::max(whole[k].high, box[k].high)};
        }
    }
    double largest = 0;
    for (const Interval& interval : whole) {
        largest = std::max(largest, interval.high - interval.low);
    }
    // A quarter of a step is more than all roundings of the origin.
    const double size = std::max(fits.reach, fits.center.cwiseAbs().maxCoeff());
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
    Vec3 origin = fits.center;
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
    const Vec3 from_center = origin - fits.center;
    const Vec3 place = in_frame(fit.axes, from_center);
    const double error = 16 * u * (fits.reach + from_center.cwiseAbs().sum());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double step = static_cast<double>(node.steps[k]);
            const double low = boxes[i][k].low - place[static_cast<int>(k)] - error;
            const double high = boxes[i][k].high - place[static_cast<int>(k)] + error;
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
    node.count = static_cast<std::uint8_t>(boxes.size());
}

/// In its own frame, or in the body's where the children's boxes are smaller there.
WideNode make_node(const Fits& fits, bool float_origin) {
    const bool in_body = fits.own.axes == body_axes ||
                         fits.body.cost(fits.children) < 1.001 * fits.own.cost(fits.children);
    WideNode node;
    quantise(fits, in_body ? fits.body : fits.own, float_origin, node);
    return node;
}

void Maker::make(std::size_t begin, std::span<WideNode> nodes) const {
    const std::span<const WidePlanNode> planned = plan_.subspan(begin, nodes.size());
    std::vector<Moments> moments;
    for (const WidePlanNode& node : planned) {
        if (node.is_leaf()) {
            moments.push_back(leaf_moments(node));
        }
    }
    const std::vector<Axes> axes = fit_axes(moments);
    std::size_t leaf = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool is_leaf = planned[i].is_leaf();
        const Fits fits = is_leaf ? fit_leaf(planned[i], axes[leaf++]) : fit_inner(planned[i]);
        nodes[i] = make_node(fits, is_leaf && blocks_.doubles.empty());
        nodes[i].is_leaf = is_leaf;
        nodes[i].first = is_leaf ? block_of(planned[i]) : planned[i].first;
    }
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

/// The leaves in the order in which the plan has them.
std::vector<std::uint32_t> leaves_in(std::span<const WidePlanNode> plan) {
    std::vector<std::uint32_t> leaves;
    for (const WidePlanNode& node : plan) {
        if (node.is_leaf()) {
            leaves.push_back(node.first);
        }
    }
    return leaves;
}

std::vector<std::uint32_t> inverse_of(std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> places(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        places[order[i]] = static_cast<std::uint32_t>(i);
    }
    return places;
}

std::vector<WideNode> make_nodes(const Maker& maker, std::size_t count, ThreadPool* pool) {
    // The first nodes take as long as many others: each is a task of its own.
    constexpr std::size_t alone = 32;
    constexpr std::size_t at_once = 64;
    std::vector<WideNode> nodes(count);
    const std::size_t large = std::min(alone, count);
    const std::size_t tasks = large + (count - large + at_once - 1) / at_once;
    parallel_for(pool, tasks, [&](std::size_t task) {
        const std::size_t begin = task < large ? task : large + (task - large) * at_once;
        const std::size_t end = task < large ? task + 1 : std::min(count, begin + at_once);
        maker.make(begin, std::span(nodes).subspan(begin, end - begin));
    });
    return nodes;
}

/// What a tree that was made here is shown of.
struct Arrays {
    std::vector<WideNode> nodes;
    WideBlocks blocks;
};

} // namespace

WideTree::WideTree(const TreeView& binary, ThreadPool* pool) {
    if (!is_suitable(binary)) {
        return;
    }
    const WideLeaves leaves = make_wide_leaves(binary, pool);
    const std::vector<WidePlanNode> plan = plan_wide_tree(binary, leaves);
    const std::vector<std::uint32_t> leaf_of_block = leaves_in(plan);
    auto arrays = std::make_shared<Arrays>();
    arrays->blocks =
        make_wide_blocks(binary, leaves, leaf_of_block, precision_of(binary.vertices), pool);
    const TriangleBlocks blocks = arrays->blocks.view();
    const std::vector<std::uint32_t> block_of_leaf = inverse_of(leaf_of_block);
    arrays->nodes =
        make_nodes(Maker(binary, leaves, plan, block_of_leaf, blocks), plan.size(), pool);
    double extent = 0;
    for (const WideNode& node : arrays->nodes) {
        for (const double coordinate : node.origin) {
            extent = std::max(extent, std::abs(coordinate));
        }
    }
    view_ = {arrays->nodes, blocks, extent};
    owner_ = std::move(arrays);
}

std::uint64_t WideTree::memory_bytes() const {
    const TriangleBlocks& blocks = view_.triangles;
    return view_.nodes.size_bytes() + blocks.floats.size_bytes() + blocks.doubles.size_bytes() +
           blocks.vertex_begin.size_bytes() + blocks.corners.size_bytes() + blocks.ids.size_bytes();
}

} // namespace cd
