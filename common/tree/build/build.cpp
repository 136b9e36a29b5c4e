#include "common/tree/build/build.hpp"

#include "common/core/check.hpp"
#include "common/geometry/topology_stop.hpp"
#include "common/tree/build/build_fit.hpp"
#include "common/tree/build/build_node.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <latch>
#include <optional>
#include <span>
#include <thread>
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

/// Whether a build is to end. All its threads may ask; only the one that made this polls the check.
class BuildStop {
  public:
    explicit BuildStop(const StopCheck& check) : check_(check) {}

    [[nodiscard]] bool is_set() {
        if (std::this_thread::get_id() == caller_ && !stopped_ && check_ && check_()) {
            stopped_ = true;
        }
        return stopped_;
    }
    [[nodiscard]] const std::atomic<bool>& flag() const { return stopped_; }

  private:
    const StopCheck& check_;
    std::thread::id caller_ = std::this_thread::get_id();
    std::atomic<bool> stopped_ = false;
};

class Builder {
  public:
    Builder(const Mesh& mesh, const BuildOptions& options, ThreadPool& pool, BuildStop& stop)
        : input_{mesh.vertices(), options, is_measurable(mesh)}, pool_(pool), stop_(stop) {
        triangles_.reserve(mesh.triangles().size());
        for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
            triangles_.push_back({mesh.triangles()[i], i});
        }
    }

    /// Builds all nodes, unless it is stopped.
    void build() {
        build_top();
        std::atomic<std::size_t> next{0};
        parallel_for(pool_, pool_.size(), [&](std::size_t) {
            SubtreeMaker maker(input_);
            for (std::size_t i = next++; i < tasks_.size() && !stop_.is_set(); i = next++) {
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
    BuildStop& stop_;
    std::vector<BuildTriangle> triangles_;
    std::vector<TopNode> top_;
    std::vector<std::uint32_t> tasks_; ///< Indices in `top_`.
};

void Builder::build_top() {
    std::vector<std::uint32_t> places; ///< Indices in `top_` of the next wave's nodes.
    std::vector<NodeToMake> wave;
    const auto add_node = [&](std::uint32_t begin, std::uint32_t end) {
        const auto place = static_cast<std::uint32_t>(top_.size());
        ObbNode& node = top_.emplace_back().box;
        node.triangles_begin = begin;
        node.triangles_end = end;
        if (end - begin > piece_triangles_max && end - begin > input_.options.leaf_triangles_max) {
            places.push_back(place);
            wave.push_back({node, triangles_of(node)});
        } else {
            tasks_.push_back(place);
        }
        return place;
    };
    add_node(0, static_cast<std::uint32_t>(triangles_.size()));
    if (wave.empty()) {
        return;
    }
    LargeNodeMaker maker(input_, triangles_.size(), pool_);
    while (!wave.empty() && !stop_.is_set()) {
        std::vector<NodeToMake> made = std::exchange(wave, {});
        const std::vector<std::uint32_t> made_places = std::exchange(places, {});
        maker.make(made);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const ObbNode& box = made[i].node;
            const std::uint32_t middle = box.triangles_begin + made[i].left_count;
            const std::uint32_t left = add_node(box.triangles_begin, middle);
            const std::uint32_t right = add_node(middle, box.triangles_end);
            top_[made_places[i]].box = box;
            top_[made_places[i]].children = {left, right};
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

std::optional<ObbTree> build_tree_until(const StopCheck& stop,
                                        std::shared_ptr<const Mesh> mesh,
                                        const BuildOptions& options,
                                        ThreadPool& pool) {
    CD_CHECK(options.leaf_triangles_max >= 1);
    BuildStop stopped(stop);
    // Analysing the topology takes as long as building the tree and is independent of it.
    std::optional<Topology> topology;
    std::latch analysed(1);
    pool.post([&] {
        topology = analyse_topology(*mesh, stopped.flag());
        analysed.count_down();
    });
    Builder builder(*mesh, options, pool, stopped);
    builder.build();
    while (stop && !analysed.try_wait() && !stopped.is_set()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    analysed.wait();
    if (stopped.is_set() || !topology) {
        return std::nullopt;
    }
    ObbTree tree(std::move(mesh), builder.assemble(), builder.triangle_ids(), std::move(*topology));
    if (options.prepare_search) {
        tree.prepare_search(&pool);
    }
    return tree;
}

ObbTree
build_tree(std::shared_ptr<const Mesh> mesh, const BuildOptions& options, ThreadPool& pool) {
    return std::move(*build_tree_until({}, std::move(mesh), options, pool));
}

} // namespace cd
