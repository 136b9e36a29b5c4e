#include "common/tree/wide/wide_collapse.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <array>

namespace cd {

namespace {

constexpr std::uint32_t children_max = block_size;

/// Returns half the surface area of the node's box.
float surface(const ObbNode& node) {
    const auto& [x, y, z] = node.half;
    return 4 * (x * y + y * z + z * x);
}

/// Entry i is the least sum of surfaces if a part of the tree becomes at most i + 1 children.
using Costs = std::array<float, children_max>;

class Planner {
  public:
    Planner(const TreeView& tree, const WideLeaves& leaves)
        : tree_(tree), leaves_(leaves), upper_index_(tree.nodes.size(), 0) {}

    std::vector<WidePlanNode> plan();

  private:
    /// One child of a planned node: a leaf, or an inner node.
    struct Child {
        std::uint32_t number = 0; ///< Number of the leaf or of the binary node.
        bool is_leaf = false;
    };

    void find_costs();
    void add_group_costs(const WideGroup& group, Costs& costs) const;
    void add_inner_costs(std::uint32_t node, Costs& costs) const;
    [[nodiscard]] bool is_group(std::uint32_t node) const { return group_of_[upper_index_[node]]; }
    [[nodiscard]] const Costs& costs_of(std::uint32_t node) const {
        return costs_[upper_index_[node]];
    }
    [[nodiscard]] std::uint32_t share_of_left(std::uint32_t node, std::uint32_t children) const;
    void children_of(std::uint32_t node, std::vector<Child>& to) const;
    [[nodiscard]] WidePlanNode node_of(const Child& child) const;

    const TreeView& tree_;
    const WideLeaves& leaves_;
    /// For each binary node, its index in `costs_`, if the node is a group or above groups.
    std::vector<std::uint32_t> upper_index_;
    std::vector<Costs> costs_; ///< Indexed by `upper_index_`.
    /// Indexed by `upper_index_`: 1 + the group's number; 0 for a node above groups.
    std::vector<std::uint32_t> group_of_;
};

/// Returns how many of `children` wide children a node's left part becomes, at least cost.
std::uint32_t Planner::share_of_left(std::uint32_t node, std::uint32_t children) const {
    const Costs& left = costs_of(node + 1);
    const Costs& right = costs_of(tree_.nodes[node].right);
    std::uint32_t best = 1;
    for (std::uint32_t share = 2; share < children; ++share) {
        if (left[share - 1] + right[children - share - 1] <
            left[best - 1] + right[children - best - 1]) {
            best = share;
        }
    }
    return best;
}

void Planner::add_group_costs(const WideGroup& group, Costs& costs) const {
    float sum = 0;
    for (std::uint32_t i = group.leaves_begin; i < group.leaves_end; ++i) {
        sum += leaves_.leaves[i].surface;
    }
    for (std::uint32_t children = 1; children <= children_max; ++children) {
        const bool fits = children >= group.leaves_end - group.leaves_begin;
        costs[children - 1] = fits ? sum : sum + surface(tree_.nodes[group.node]);
    }
}

void Planner::add_inner_costs(std::uint32_t node, Costs& costs) const {
    const Costs& left = costs_of(node + 1);
    const Costs& right = costs_of(tree_.nodes[node].right);
    for (std::uint32_t children = 2; children <= children_max; ++children) {
        const std::uint32_t share = share_of_left(node, children);
        costs[children - 1] = left[share - 1] + right[children - share - 1];
    }
    costs[0] = costs[children_max - 1] + surface(tree_.nodes[node]);
    for (float& cost : costs) {
        cost = std::min(cost, costs[0]);
    }
}

void Planner::find_costs() {
    // All groups and the nodes above groups, in preorder.
    std::vector<std::uint32_t> upper;
    std::vector<std::uint32_t> stack = {0};
    std::uint32_t group = 0;
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        upper_index_[node] = static_cast<std::uint32_t>(upper.size());
        upper.push_back(node);
        if (group < leaves_.groups.size() && leaves_.groups[group].node == node) {
            group_of_.push_back(++group);
        } else {
            group_of_.push_back(0);
            stack.push_back(tree_.nodes[node].right);
            stack.push_back(node + 1);
        }
    }
    costs_.resize(upper.size());
    for (std::size_t i = upper.size(); i-- > 0;) {
        if (group_of_[i] != 0) {
            add_group_costs(leaves_.groups[group_of_[i] - 1], costs_[i]);
        } else {
            add_inner_costs(upper[i], costs_[i]);
        }
    }
}

void Planner::children_of(std::uint32_t node, std::vector<Child>& to) const {
    struct Part {
        std::uint32_t node;
        std::uint32_t children; ///< Most children that the node may become.
    };
    const auto add_leaves = [&](std::uint32_t of) {
        const WideGroup& group = leaves_.groups[group_of_[upper_index_[of]] - 1];
        for (std::uint32_t i = group.leaves_begin; i < group.leaves_end; ++i) {
            to.push_back({i, true});
        }
    };
    if (is_group(node)) {
        add_leaves(node);
        return;
    }
    std::vector<Part> stack;
    const auto push_halves = [&](const Part& part) {
        const std::uint32_t share = share_of_left(part.node, part.children);
        stack.push_back({tree_.nodes[part.node].right, part.children - share});
        stack.push_back({part.node + 1, share});
    };
    push_halves({node, children_max});
    while (!stack.empty()) {
        const Part part = stack.back();
        stack.pop_back();
        const Costs& costs = costs_of(part.node);
        const WideGroup* group =
            is_group(part.node) ? &leaves_.groups[group_of_[upper_index_[part.node]] - 1] : nullptr;
        if (group != nullptr && group->leaves_end - group->leaves_begin <= part.children) {
            add_leaves(part.node);
        } else if (group != nullptr || part.children == 1 ||
                   !(costs[part.children - 1] < costs[0])) {
            to.push_back({part.node, false});
        } else {
            push_halves(part);
        }
    }
}

WidePlanNode Planner::node_of(const Child& child) const {
    WidePlanNode node;
    if (child.is_leaf) {
        const WideLeaf& leaf = leaves_.leaves[child.number];
        node.begin = leaf.begin;
        node.end = leaf.end;
        node.first = child.number;
    } else {
        // `WideLeaves::order` differs from the tree's order only within groups.
        node.begin = tree_.nodes[child.number].triangles_begin;
        node.end = tree_.nodes[child.number].triangles_end;
        node.binary = child.number;
        node.count = 1; // A preliminary count, until the children are known.
    }
    return node;
}

std::vector<WidePlanNode> Planner::plan() {
    std::vector<WidePlanNode> nodes;
    if (leaves_.leaves.size() == 1) {
        nodes.push_back(node_of({0, true}));
        return nodes;
    }
    find_costs();
    nodes.push_back(node_of({0, false}));
    std::vector<std::uint32_t> stack = {0};
    std::vector<Child> children;
    while (!stack.empty()) {
        const std::uint32_t index = stack.back();
        stack.pop_back();
        if (nodes[index].is_leaf()) {
            continue;
        }
        children.clear();
        children_of(nodes[index].binary, children);
        const auto first = static_cast<std::uint32_t>(nodes.size());
        nodes[index].first = first;
        nodes[index].count = static_cast<std::uint32_t>(children.size());
        for (const Child& child : children) {
            nodes.push_back(node_of(child));
        }
        for (auto i = nodes[index].count; i-- > 0;) {
            stack.push_back(first + i);
        }
    }
    return nodes;
}

} // namespace

std::vector<WidePlanNode> plan_wide_tree(const TreeView& tree, const WideLeaves& leaves) {
    return Planner(tree, leaves).plan();
}

} // namespace cd
