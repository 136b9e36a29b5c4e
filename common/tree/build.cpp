#include "common/tree/build.hpp"

#include "common/core/check.hpp"
#include "common/tree/build_fit.hpp"
#include "common/tree/build_split.hpp"

#include <algorithm>
#include <array>
#include <latch>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// A node with more triangles is made on its own, in a wave of its equals; the others are made
/// together with all below them, one task each.
constexpr std::uint32_t task_triangles_max = 4096;

constexpr std::uint32_t none = ~std::uint32_t{0};

struct Scratch {
    Projections projections;
    SplitScratch split;
    std::vector<BuildTriangle> triangles;
};

/// A node above the tasks, or the place of a task.
struct TopNode {
    ObbNode box;
    std::array<std::uint32_t, 2> children = {none, none}; ///< Places among the top nodes.
    std::vector<ObbNode> subtree;                         ///< Of a task; indices from 0.
};

class Builder {
  public:
    Builder(const Mesh& mesh, const BuildOptions& options, ThreadPool& pool)
        : vertices_(mesh.vertices()),
          options_(options),
          pool_(pool),
          measurable_(std::ranges::all_of(vertices_, [](const Vec3& vertex) {
              return vertex.cwiseAbs().maxCoeff() < coordinate_max;
          })) {
        triangles_.reserve(mesh.triangles().size());
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            triangles_.push_back({mesh.triangles()[i], i});
        }
    }

    void build() {
        build_top();
        parallel_for(pool_, tasks_.size(), [this](std::size_t i) { build_task(top_[tasks_[i]]); });
    }

    /// All nodes in preorder.
    [[nodiscard]] std::vector<ObbNode> assemble() const;

    [[nodiscard]] std::vector<std::uint32_t> triangle_ids() const {
        std::vector<std::uint32_t> ids;
        ids.reserve(triangles_.size());
        for (const BuildTriangle& triangle : triangles_) {
            ids.push_back(triangle.id);
        }
        return ids;
    }

  private:
    void build_top();
    void build_task(TopNode& task);
    std::uint32_t make_node(ObbNode& node, Scratch& scratch, ThreadPool* pool);
    std::uint32_t
    part(std::span<BuildTriangle> triangles, Scratch& scratch, ThreadPool* pool) const;

    std::span<const Vec3> vertices_;
    BuildOptions options_;
    ThreadPool& pool_;
    bool measurable_;
    std::vector<BuildTriangle> triangles_;
    std::vector<TopNode> top_;
    std::vector<std::uint32_t> tasks_; ///< Places among the top nodes.
};

/// Sets the box of the node's triangles and puts those of the left child first. How many these are;
/// 0 for a leaf. Looks at these triangles alone, so nodes apart may be made at once in any order.
std::uint32_t Builder::make_node(ObbNode& node, Scratch& scratch, ThreadPool* pool) {
    const std::span<BuildTriangle> triangles =
        std::span(triangles_).subspan(node.triangles_begin, node.triangle_count());
    const bool leaf = triangles.size() <= options_.leaf_triangles_max;
    if (!measurable_) {
        set_unbounded_box(node);
        return leaf ? 0 : node.triangle_count() / 2;
    }
    node.axes = options_.boxes == BoxKind::Obb ? fit_axes(triangles, vertices_) : body_axes;
    project(triangles, vertices_, node.axes, scratch.projections);
    set_box(scratch.projections, node);
    return leaf ? 0 : part(triangles, scratch, pool);
}

std::uint32_t
Builder::part(std::span<BuildTriangle> triangles, Scratch& scratch, ThreadPool* pool) const {
    const std::optional<Split> split =
        choose_split(scratch.projections, options_.rule, scratch.split, pool);
    if (!split) {
        // All alike: any halves do.
        return static_cast<std::uint32_t>(triangles.size() / 2);
    }
    const auto& intervals = scratch.projections.triangles[split->axis];
    const Interval& whole = scratch.projections.whole[split->axis];
    // Both sides keep their order, so that no library's way of sorting enters the tree.
    std::uint32_t left = 0;
    scratch.triangles.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (split_rank(intervals[i], whole, i) <= split->last_rank) {
            triangles[left++] = triangles[i];
        } else {
            scratch.triangles.push_back(triangles[i]);
        }
    }
    CD_CHECK(left == split->left_count);
    std::copy(scratch.triangles.begin(), scratch.triangles.end(), triangles.begin() + left);
    return left;
}

void Builder::build_top() {
    std::vector<std::uint32_t> wave;
    const auto add_node = [&](std::uint32_t begin, std::uint32_t end) {
        const auto place = static_cast<std::uint32_t>(top_.size());
        TopNode& node = top_.emplace_back();
        node.box.triangles_begin = begin;
        node.box.triangles_end = end;
        (end - begin > task_triangles_max ? wave : tasks_).push_back(place);
        return place;
    };
    add_node(0, static_cast<std::uint32_t>(triangles_.size()));
    while (!wave.empty()) {
        const std::vector<std::uint32_t> made = std::exchange(wave, {});
        std::vector<std::uint32_t> lefts(made.size(), 0);
        if (made.size() == 1) {
            Scratch scratch;
            lefts[0] = make_node(top_[made[0]].box, scratch, &pool_);
        } else {
            parallel_for(pool_, made.size(), [&](std::size_t i) {
                Scratch scratch;
                lefts[i] = make_node(top_[made[i]].box, scratch, nullptr);
            });
        }
        for (std::size_t i = 0; i < made.size(); ++i) {
            if (lefts[i] != 0) {
                const ObbNode box = top_[made[i]].box;
                const std::uint32_t middle = box.triangles_begin + lefts[i];
                const std::uint32_t left = add_node(box.triangles_begin, middle);
                const std::uint32_t right = add_node(middle, box.triangles_end);
                top_[made[i]].children = {left, right};
            }
        }
    }
}

void Builder::build_task(TopNode& task) {
    struct Waiting {
        std::uint32_t begin;
        std::uint32_t end;
        std::uint32_t parent; ///< Of a right child, to be told where it stands.
    };
    Scratch scratch;
    std::vector<ObbNode>& nodes = task.subtree;
    std::vector<Waiting> waiting = {{task.box.triangles_begin, task.box.triangles_end, none}};
    while (!waiting.empty()) {
        const Waiting now = waiting.back();
        waiting.pop_back();
        const auto place = static_cast<std::uint32_t>(nodes.size());
        if (now.parent != none) {
            nodes[now.parent].right = place;
        }
        ObbNode& node = nodes.emplace_back();
        node.triangles_begin = now.begin;
        node.triangles_end = now.end;
        const std::uint32_t left = make_node(node, scratch, nullptr);
        if (left != 0) {
            waiting.push_back({now.begin + left, now.end, place});
            waiting.push_back({now.begin, now.begin + left, none});
        }
    }
}

std::vector<ObbNode> Builder::assemble() const {
    struct Waiting {
        std::uint32_t top;
        std::uint32_t parent; ///< Of a right child, in the result.
    };
    std::size_t count = top_.size() - tasks_.size();
    for (const std::uint32_t task : tasks_) {
        count += top_[task].subtree.size();
    }
    std::vector<ObbNode> nodes;
    nodes.reserve(count);
    std::vector<Waiting> waiting = {{0, none}};
    while (!waiting.empty()) {
        const Waiting now = waiting.back();
        waiting.pop_back();
        const TopNode& top = top_[now.top];
        const auto place = static_cast<std::uint32_t>(nodes.size());
        if (now.parent != none) {
            nodes[now.parent].right = place;
        }
        if (top.subtree.empty()) {
            nodes.push_back(top.box);
        }
        for (const ObbNode& node : top.subtree) {
            nodes.push_back(node);
            nodes.back().right += node.is_leaf() ? 0 : place;
        }
        if (top.children[1] != none) {
            waiting.push_back({top.children[1], place});
            waiting.push_back({top.children[0], none});
        }
    }
    return nodes;
}

} // namespace

ObbTree
build_tree(std::shared_ptr<const Mesh> mesh, const BuildOptions& options, ThreadPool& pool) {
    CD_CHECK(options.leaf_triangles_max >= 1);
    // As long as the tree, and apart from it.
    Topology topology;
    std::latch analysed(1);
    pool.post([&] {
        topology = analyse_topology(*mesh);
        analysed.count_down();
    });
    Builder builder(*mesh, options, pool);
    builder.build();
    analysed.wait();
    ObbTree tree(std::move(mesh), builder.assemble(), builder.triangle_ids(), std::move(topology));
    if (options.prepare_search) {
        tree.prepare_search();
    }
    return tree;
}

} // namespace cd
