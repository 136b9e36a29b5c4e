#include "common/tree/wide/wide_tree.hpp"

#include "common/core/check.hpp"
#include "common/tree/build/build_fit.hpp"
#include "common/tree/planes/support_points.hpp"
#include "common/tree/wide/wide_boxes.hpp"
#include "common/tree/wide/wide_collapse.hpp"
#include "common/tree/wide/wide_frame.hpp"
#include "common/tree/wide/wide_leaves.hpp"
#include "common/tree/wire/wide_blocks.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace cd {

namespace {

using Axes = WideBoxes::Axes;

/// Returns the moments of a block's triangles.
Moments moments_of(const TriangleBlocks& blocks, std::uint32_t block, std::uint32_t count) {
    std::array<Vec3, block_vertices_max> vertices;
    const std::size_t first = blocks.vertex_begin[block];
    const std::size_t vertex_count = blocks.vertex_begin[block + 1] - first;
    for (std::size_t i = 0; i < vertex_count; ++i) {
        vertices[i] = blocks.vertex(first + i);
    }
    std::array<BuildTriangle, block_size> triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const BlockCorners& corners = blocks.corners[std::size_t{block_size} * block + i];
        triangles[i].vertices = {corners[0], corners[1], corners[2]};
    }
    return sum_moments(
        std::span(triangles).first(count), std::span(vertices).first(vertex_count), vertices[0]);
}

/// Makes a node in the encodable frame that is closest to `own`, or in the body's frame if the
/// children's boxes are smaller there.
WideNode make_node(const WideBoxes& boxes, std::size_t place, const Axes& own) {
    const WideNode in_body = boxes.in_frame(place, body_axes);
    const FrameCode code = code_of(own);
    if (code.kind == 0) {
        return in_body;
    }
    const WideNode in_own = boxes.in_frame(place, frame_of(code).value());
    return cost_of(in_body) < 1.001 * cost_of(in_own) ? in_body : in_own;
}

/// Completes the nodes of a plan, in which only the children are set.
class Maker {
  public:
    Maker(const TreeView& tree,
          std::span<const WidePlanNode> plan,
          const TriangleBlocks& blocks,
          std::span<WideNode> nodes)
        : tree_(tree), plan_(plan), blocks_(blocks), nodes_(nodes), boxes_(blocks, nodes) {}

    /// Completes `count` nodes from `begin` on. Any number of threads may call this at once.
    void make(std::size_t begin, std::size_t count) const;

  private:
    const TreeView& tree_;
    std::span<const WidePlanNode> plan_;
    TriangleBlocks blocks_;
    std::span<WideNode> nodes_;
    WideBoxes boxes_;
};

void Maker::make(std::size_t begin, std::size_t count) const {
    const std::span<WideNode> nodes = nodes_.subspan(begin, count);
    std::vector<Moments> moments;
    for (const WideNode& node : nodes) {
        if (node.is_leaf) {
            moments.push_back(moments_of(blocks_, node.first, node.count));
        }
    }
    const std::vector<Axes> axes = fit_axes(moments);
    std::size_t leaf = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Axes& own =
            nodes[i].is_leaf ? axes[leaf++] : tree_.nodes[plan_[begin + i].binary].axes;
        nodes[i] = make_node(boxes_, begin + i, own);
    }
}

bool has_small_leaves(std::span<const ObbNode> nodes) {
    return std::ranges::all_of(nodes, [](const ObbNode& node) {
        return !node.is_leaf() || node.triangle_count() <= block_size * block_size;
    });
}

/// Returns the numbers of the leaves in the order of the plan.
std::vector<std::uint32_t> leaves_in(std::span<const WidePlanNode> plan) {
    std::vector<std::uint32_t> leaves;
    for (const WidePlanNode& node : plan) {
        if (node.is_leaf()) {
            leaves.push_back(node.first);
        }
    }
    return leaves;
}

/// Returns the nodes without their boxes. Blocks have the order of the plan's leaves.
std::vector<WideNode> outline_of(std::span<const WidePlanNode> plan) {
    std::vector<WideNode> nodes(plan.size());
    std::uint32_t block = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const WidePlanNode& planned = plan[i];
        nodes[i].is_leaf = planned.is_leaf();
        nodes[i].first = planned.is_leaf() ? block++ : planned.first;
        nodes[i].count = static_cast<std::uint8_t>(planned.is_leaf() ? planned.end - planned.begin
                                                                     : planned.count);
    }
    return nodes;
}

void make_nodes(const Maker& maker, std::size_t count, ThreadPool* pool) {
    // The first nodes take as long as many others, so each is a task of its own.
    constexpr std::size_t alone = 32;
    constexpr std::size_t at_once = 64;
    const std::size_t large = std::min(alone, count);
    const std::size_t tasks = large + (count - large + at_once - 1) / at_once;
    parallel_for(pool, tasks, [&](std::size_t task) {
        const std::size_t begin = task < large ? task : large + (task - large) * at_once;
        maker.make(begin, task < large ? 1 : std::min(at_once, count - begin));
    });
}

struct Arrays {
    std::vector<WideNode> nodes;
    WideBlocks blocks;
};

} // namespace

bool suits_wide_tree(const TreeView& body) {
    double reach = 0;
    Vec3 low = body.vertices.front();
    Vec3 high = low;
    for (const Vec3& vertex : body.vertices) {
        reach = std::max(reach, vertex.cwiseAbs().maxCoeff());
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    return has_small_leaves(body.nodes) && reach < wide_coordinate_max &&
           (high - low).maxCoeff() > wide_size_min;
}

WideTree::WideTree(const TreeView& binary, ThreadPool* pool)
    : WideTree(suits_wide_tree(binary) ? of_part(binary, pool)
                                       : WideTree(WideView(), std::shared_ptr<const void>())) {}

WideTree WideTree::of_part(const TreeView& binary, ThreadPool* pool) {
    const WideLeaves leaves = make_wide_leaves(binary, pool);
    const std::vector<WidePlanNode> plan = plan_wide_tree(binary, leaves);
    auto arrays = std::make_shared<Arrays>();
    arrays->blocks =
        make_wide_blocks(binary, leaves, leaves_in(plan), precision_of(binary.vertices), pool);
    arrays->nodes = outline_of(plan);
    const TriangleBlocks blocks = arrays->blocks.view();
    make_nodes(Maker(binary, plan, blocks, arrays->nodes), plan.size(), pool);
    return WideTree({arrays->nodes, blocks, extent_of(arrays->nodes)}, arrays);
}

WideTree WideTree::with_support(ThreadPool* pool) const {
    struct Owner {
        std::shared_ptr<const void> arrays;
        SupportPoints points;
    };
    auto owner = std::make_shared<Owner>(owner_, SupportPoints(view_, pool));
    WideView view = view_;
    view.support = owner->points.view();
    return {view, std::move(owner)};
}

std::uint64_t WideTree::memory_bytes() const {
    const TriangleBlocks& blocks = view_.triangles;
    return view_.nodes.size_bytes() + blocks.floats.size_bytes() + blocks.doubles.size_bytes() +
           blocks.vertex_begin.size_bytes() + blocks.corners.size_bytes() +
           blocks.ids.size_bytes() + view_.support.sets.size_bytes() +
           view_.support.columns.size_bytes();
}

} // namespace cd
