#include "common/tree/wide_leaves.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace cd {

namespace {

constexpr std::uint32_t group_triangles_max = block_size * block_size;

/// A box for choosing splits: neither exact nor conservative.
struct RoughBox {
    std::array<float, 3> low;
    std::array<float, 3> high;

    void add(const RoughBox& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    [[nodiscard]] float surface() const {
        const float x = high[0] - low[0];
        const float y = high[1] - low[1];
        const float z = high[2] - low[2];
        return x * y + y * z + z * x;
    }
};

constexpr RoughBox empty_box = {{std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::infinity()},
                                {-std::numeric_limits<float>::infinity(),
                                 -std::numeric_limits<float>::infinity(),
                                 -std::numeric_limits<float>::infinity()}};

constexpr std::uint32_t leaves_for(std::uint32_t triangles) {
    return (triangles + block_size - 1) / block_size;
}

/// Makes the leaves of one group after the other.
class GroupSplitter {
  public:
    GroupSplitter(const TreeView& tree, WideLeaves& to) : tree_(tree), to_(to) {}

    void add_group(std::uint32_t node);

  private:
    struct Split {
        float cost = std::numeric_limits<float>::infinity();
        std::size_t axis = 0;
        std::uint32_t left = 0;
    };

    void measure(const ObbNode& node);
    void sort(std::uint32_t begin, std::uint32_t end, std::size_t axis);
    void find_split(std::uint32_t begin, std::uint32_t end, std::size_t axis, Split& best);
    void split(std::uint32_t begin, std::uint32_t end);
    void add_leaf(std::uint32_t begin, std::uint32_t end);

    const TreeView& tree_;
    WideLeaves& to_;
    std::uint32_t first_ = 0;       ///< The group's first triangle.
    std::vector<RoughBox> boxes_;   ///< Of the group's triangles, in the tree's order.
    std::vector<std::uint32_t> at_; ///< The group's triangles in the order that is being made.
    std::vector<float> left_costs_;
};

void GroupSplitter::measure(const ObbNode& node) {
    boxes_.clear();
    for (std::uint32_t i = node.triangles_begin; i < node.triangles_end; ++i) {
        RoughBox box = empty_box;
        for (const std::uint32_t vertex : tree_.triangles[i]) {
            std::array<float, 3> from_center;
            for (std::size_t k = 0; k < 3; ++k) {
                from_center[k] = static_cast<float>(tree_.vertices[vertex][static_cast<int>(k)] -
                                                    node.center[k]);
            }
            RoughBox corner;
            for (std::size_t k = 0; k < 3; ++k) {
                corner.low[k] = node.axes[3 * k] * from_center[0] +
                                node.axes[3 * k + 1] * from_center[1] +
                                node.axes[3 * k + 2] * from_center[2];
                corner.high[k] = corner.low[k];
            }
            box.add(corner);
        }
        boxes_.push_back(box);
    }
}

/// By the middle of the boxes; where these are equal, in the tree's order.
void GroupSplitter::sort(std::uint32_t begin, std::uint32_t end, std::size_t axis) {
    const auto middle = [&](std::uint32_t i) { return boxes_[i].low[axis] + boxes_[i].high[axis]; };
    std::sort(at_.begin() + begin, at_.begin() + end, [&](std::uint32_t i, std::uint32_t j) {
        return middle(i) != middle(j) ? middle(i) < middle(j) : i < j;
    });
}

void GroupSplitter::find_split(std::uint32_t begin,
                               std::uint32_t end,
                               std::size_t axis,
                               Split& best) {
    const std::uint32_t count = end - begin;
    left_costs_.resize(count);
    RoughBox box = empty_box;
    for (std::uint32_t left = 1; left < count; ++left) {
        box.add(boxes_[at_[begin + left - 1]]);
        left_costs_[left] = box.surface() * static_cast<float>(leaves_for(left));
    }
    box = empty_box;
    for (std::uint32_t left = count - 1; left > 0; --left) {
        box.add(boxes_[at_[begin + left]]);
        const std::uint32_t leaves_right = leaves_for(count - left);
        if (leaves_for(left) + leaves_right != leaves_for(count)) {
            continue;
        }
        const float cost = left_costs_[left] + box.surface() * static_cast<float>(leaves_right);
        if (cost < best.cost) {
            best = {cost, axis, left};
        }
    }
}

void GroupSplitter::add_leaf(std::uint32_t begin, std::uint32_t end) {
    const auto first = static_cast<std::uint32_t>(to_.order.size());
    RoughBox box = empty_box;
    for (std::uint32_t i = begin; i < end; ++i) {
        box.add(boxes_[at_[i]]);
        to_.order.push_back(first_ + at_[i]);
    }
    to_.leaves.push_back({first, first + end - begin, box.surface()});
}

/// The depth of this recursion is at most the number of a group's leaves.
void GroupSplitter::split(std::uint32_t begin, std::uint32_t end) {
    if (leaves_for(end - begin) == 1) {
        add_leaf(begin, end);
        return;
    }
    Split best;
    best.left = block_size; // Where nothing can be compared.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sort(begin, end, axis);
        find_split(begin, end, axis, best);
    }
    if (best.axis != 2) {
        sort(begin, end, best.axis);
    }
    split(begin, begin + best.left);
    split(begin + best.left, end);
}

void GroupSplitter::add_group(std::uint32_t node) {
    const ObbNode& box = tree_.nodes[node];
    first_ = box.triangles_begin;
    measure(box);
    at_.clear();
    for (std::uint32_t i = 0; i < box.triangle_count(); ++i) {
        at_.push_back(i);
    }
    const auto begin = static_cast<std::uint32_t>(to_.leaves.size());
    split(0, box.triangle_count());
    to_.groups.push_back({node, begin, static_cast<std::uint32_t>(to_.leaves.size())});
}

} // namespace

WideLeaves make_wide_leaves(const TreeView& tree) {
    WideLeaves leaves;
    leaves.order.reserve(tree.triangles.size());
    GroupSplitter splitter(tree, leaves);
    std::vector<std::uint32_t> stack = {0};
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        if (tree.nodes[node].is_leaf() ||
            tree.nodes[node].triangle_count() <= group_triangles_max) {
            splitter.add_group(node);
        } else {
            stack.push_back(tree.nodes[node].right);
            stack.push_back(node + 1);
        }
    }
    return leaves;
}

} // namespace cd
