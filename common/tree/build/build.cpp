#include "common/tree/build/build.hpp"

#include "common/core/check.hpp"
#include "common/tree/build/build_fit.hpp"
#include "common/tree/build/build_node.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <latch>
#include <span>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

/// A large node, which all threads make together, or a task: a subtree that one thread makes.
struct TopNode {
    ObbNode box;
    std::array<std::uint32_t, 2> children = {none, none}; ///< Indices in `top_`; none for a task.
    std::vector<ObbNode> subtree;                         ///< A task's nodes; indices start at 0.
};

class Builder {
  public:
    Builder(const Mesh& mesh, const BuildOptions& options, ThreadPool& pool)
        : input_{mesh.vertices(), options, is_measurable(mesh)}, pool_(pool) {
        triangles_.reserve(mesh.triangles().size());
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            triangles_.push_back({mesh.triangles()[i], i});
        }
    }

    void build() {
        build_top();
        std::atomic<std::size_t> next{0};
        parallel_for(pool_, pool_.size(), [&](std::size_t) {
            SubtreeMaker maker(input_);
            for (std::size_t i = next++; i < tasks_.size(); i = next++) {
                TopNode& task = top_[tasks_[i]];
                task.subtree = maker.make(triangles_of(task.box), task.box.triangles_begin);
            }
        });
    }

    /// Returns all nodes in preorder.
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
    static bool is_measurable(const Mesh& mesh) {
        return std::ranges::all_of(mesh.vertices(), [](const Vec3& vertex) {
            return vertex.cwiseAbs().maxCoeff() < coordinate_max;
        });
    }

    [[nodiscard]] std::span<BuildTriangle> triangles_of(const ObbNode& node) {
        return std::span(triangles_).subspan(node.triangles_begin, node.triangle_count());
    }
    void build_top();

    BuildInput input_;
    ThreadPool& pool_;
    std::vector<BuildTriangle> triangles_;
    std::vector<TopNode> top_;
    std::vector<std::uint32_t> tasks_; ///< Indices in `top_`.
};

void Builder::build_top() {
    std::vector<std::uint32_t> indices; ///< Indices in `top_` of the next wave's nodes.
    std::vector<NodeToMake> wave;
    const auto add_node = [&](std::uint32_t begin, std::uint32_t end) {
        const auto index = static_cast<std::uint32_t>(top_.size());
        ObbNode& node = top_.emplace_back().box;
        node.triangles_begin = begin;
        node.triangles_end = end;
        if (end - begin > piece_triangles_max && end - begin > input_.options.leaf_triangles_max) {
            indices.push_back(index);
            wave.push_back({node, triangles_of(node)});
        } else {
            tasks_.push_back(index);
        }
        return index;
    };
    add_node(0, static_cast<std::uint32_t>(triangles_.size()));
    if (wave.empty()) {
        return;
    }
    LargeNodeMaker maker(input_, triangles_.size(), pool_);
    while (!wave.empty()) {
        std::vector<NodeToMake> made = std::exchange(wave, {});
        const std::vector<std::uint32_t> made_indices = std::exchange(indices, {});
        maker.make(made);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const ObbNode& box = made[i].node;
            const std::uint32_t middle = box.triangles_begin + made[i].left_count;
            const std::uint32_t left = add_node(box.triangles_begin, middle);
            const std::uint32_t right = add_node(middle, box.triangles_end);
            top_[made_indices[i]].box = box;
            top_[made_indices[i]].children = {left, right};
        }
    }
}

std::vector<ObbNode> Builder::assemble() const {
    struct Waiting {
        std::uint32_t top;
        std::uint32_t parent; ///< A right child's parent, by index in the result; else `none`.
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
        const auto index = static_cast<std::uint32_t>(nodes.size());
        if (now.parent != none) {
            nodes[now.parent].right = index;
        }
        if (top.subtree.empty()) {
            nodes.push_back(top.box);
        }
        for (const ObbNode& node : top.subtree) {
            nodes.push_back(node);
            nodes.back().right += node.is_leaf() ? 0 : index;
        }
        if (top.children[1] != none) {
            waiting.push_back({top.children[1], index});
            waiting.push_back({top.children[0], none});
        }
    }
    return nodes;
}

} // namespace

ObbTree
build_tree(std::shared_ptr<const Mesh> mesh, const BuildOptions& options, ThreadPool& pool) {
    CD_CHECK(options.leaf_triangles_max >= 1);
    // Analysing the topology takes as long as building the tree and is independent of it.
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
        tree.prepare_search(&pool);
    }
    return tree;
}

} // namespace cd
