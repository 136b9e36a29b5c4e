#include "common/tree/wide/wide_leaves.hpp"

#include "common/geometry/triangle_blocks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

namespace cd {

namespace {

constexpr std::uint32_t group_triangles_max = block_size * block_size;

/// A box for choosing splits; it is neither exact nor conservative.
struct RoughBox {
    std::array<float, 3> low;
    std::array<float, 3> high;

    void add(const RoughBox& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
    /// Returns half the surface area.
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

using GroupIndex = std::uint8_t; ///< The index of a triangle in its group.
static_assert(group_triangles_max - 1 <= std::numeric_limits<GroupIndex>::max());

/// Maps floats to integers in the same order; 0 and -0 give one integer.
std::uint32_t rank_of(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
    return bits ^ ((bits >> 31) != 0 ? ~std::uint32_t{0} : std::uint32_t{1} << 31);
}

/// A rank in the high bits and the index of its triangle in the low bits.
using Key = std::uint64_t;

/// Sorts stably by rank. `scratch` is as long as `keys`.
void sort_by_rank(std::span<Key> keys, std::span<Key> scratch) {
    constexpr unsigned digits = 4;
    std::array<std::array<std::uint16_t, 256>, digits> counts{};
    const auto digit = [](Key key, unsigned d) { return (key >> (32 + 8 * d)) & 255; };
    for (const Key key : keys) {
        for (unsigned d = 0; d < digits; ++d) {
            ++counts[d][digit(key, d)];
        }
    }
    std::span<Key> from = keys;
    std::span<Key> to = scratch;
    for (unsigned d = 0; d < digits; ++d) {
        if (counts[d][digit(from.front(), d)] == from.size()) {
            continue; // All keys have the same digit.
        }
        std::uint16_t begin = 0;
        for (std::uint16_t& count : counts[d]) {
            begin += std::exchange(count, begin);
        }
        for (const Key key : from) {
            to[counts[d][digit(key, d)]++] = key;
        }
        std::swap(from, to);
    }
    if (from.data() != keys.data()) {
        std::copy(from.begin(), from.end(), keys.begin());
    }
}

/// Makes the leaves of groups, one group per call of `add_group`.
class GroupSplitter {
  public:
    explicit GroupSplitter(const TreeView& tree) : tree_(tree) {}

    /// Writes the order of the node's triangles to `order` and appends the leaves to `leaves`.
    void
    add_group(const ObbNode& node, std::span<std::uint32_t> order, std::vector<WideLeaf>& leaves);

  private:
    template <class T>
    using OfTriangles = std::array<T, group_triangles_max>;

    struct Split {
        float cost = std::numeric_limits<float>::infinity();
        std::size_t axis = 0;
        std::uint32_t left = 0;
    };

    void measure(const ObbNode& node);
    void sort();
    void find_split(std::uint32_t begin, std::uint32_t end, std::size_t axis, Split& best);
    void part(std::uint32_t begin, std::uint32_t end, const Split& split);
    void split(std::uint32_t begin, std::uint32_t end, const OfTriangles<GroupIndex>& order);
    void add_leaf(std::uint32_t begin, std::uint32_t end, const OfTriangles<GroupIndex>& order);

    const TreeView& tree_;
    std::uint32_t first_ = 0; ///< Index of the group's first triangle.
    std::uint32_t count_ = 0;
    std::span<std::uint32_t> order_;
    std::vector<WideLeaf>* leaves_ = nullptr;
    OfTriangles<RoughBox> boxes_{}; ///< Boxes of the group's triangles, in the tree's order.
    /// The group's triangles sorted by the middle of their boxes on each axis, ties in the tree's
    /// order. Every part that is still to be split is the same range on all axes.
    std::array<OfTriangles<GroupIndex>, 3> sorted_{};
    OfTriangles<float> left_costs_{};
};

void GroupSplitter::measure(const ObbNode& node) {
    for (std::uint32_t i = 0; i < count_; ++i) {
        RoughBox box = empty_box;
        for (const std::uint32_t vertex : tree_.triangles[first_ + i]) {
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
        boxes_[i] = box;
    }
}

void GroupSplitter::sort() {
    OfTriangles<Key> keys;
    OfTriangles<Key> scratch;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t i = 0; i < count_; ++i) {
            const float middle = boxes_[i].low[axis] + boxes_[i].high[axis];
            keys[i] = Key{rank_of(middle)} << 32 | i;
        }
        sort_by_rank(std::span(keys).first(count_), std::span(scratch).first(count_));
        for (std::uint32_t i = 0; i < count_; ++i) {
            sorted_[axis][i] = static_cast<GroupIndex>(keys[i]);
        }
    }
}

void GroupSplitter::find_split(std::uint32_t begin,
                               std::uint32_t end,
                               std::size_t axis,
                               Split& best) {
    const std::uint32_t count = end - begin;
    const GroupIndex* const order = &sorted_[axis][begin];
    RoughBox box = empty_box;
    for (std::uint32_t left = 1; left < count; ++left) {
        box.add(boxes_[order[left - 1]]);
        left_costs_[left] = box.surface() * static_cast<float>(leaves_for(left));
    }
    box = empty_box;
    for (std::uint32_t left = count - 1; left > 0; --left) {
        box.add(boxes_[order[left]]);
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

/// Moves the left part to the front on the other axes, too; both parts keep their order.
void GroupSplitter::part(std::uint32_t begin, std::uint32_t end, const Split& split) {
    OfTriangles<bool> is_left{};
    for (std::uint32_t i = begin; i < begin + split.left; ++i) {
        is_left[sorted_[split.axis][i]] = true;
    }
    OfTriangles<GroupIndex> right;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis == split.axis) {
            continue;
        }
        OfTriangles<GroupIndex>& order = sorted_[axis];
        std::uint32_t left_end = begin;
        std::uint32_t right_count = 0;
        for (std::uint32_t i = begin; i < end; ++i) {
            const GroupIndex index = order[i];
            order[left_end] = index;
            right[right_count] = index;
            left_end += is_left[index] ? 1 : 0;
            right_count += is_left[index] ? 0 : 1;
        }
        std::copy_n(right.begin(), right_count, order.begin() + left_end);
    }
}

void GroupSplitter::add_leaf(std::uint32_t begin,
                             std::uint32_t end,
                             const OfTriangles<GroupIndex>& order) {
    RoughBox box = empty_box;
    for (std::uint32_t i = begin; i < end; ++i) {
        box.add(boxes_[order[i]]);
        order_[i] = first_ + order[i];
    }
    std::ranges::sort(order_.subspan(begin, end - begin), {}, [&](std::uint32_t index) {
        return tree_.triangle_ids[index];
    });
    leaves_->push_back({first_ + begin, first_ + end, box.surface()});
}

/// Splits a part recursively. The depth is at most the number of the group's leaves.
void GroupSplitter::split(std::uint32_t begin,
                          std::uint32_t end,
                          const OfTriangles<GroupIndex>& order) {
    if (leaves_for(end - begin) == 1) {
        add_leaf(begin, end, order);
        return;
    }
    Split best;
    best.left = block_size; // Unchanged if all costs are infinite or NaN.
    for (std::size_t axis = 0; axis < 3; ++axis) {
        find_split(begin, end, axis, best);
    }
    part(begin, end, best);
    split(begin, begin + best.left, sorted_[best.axis]);
    split(begin + best.left, end, sorted_[best.axis]);
}

void GroupSplitter::add_group(const ObbNode& node,
                              std::span<std::uint32_t> order,
                              std::vector<WideLeaf>& leaves) {
    first_ = node.triangles_begin;
    count_ = node.triangle_count();
    order_ = order;
    leaves_ = &leaves;
    measure(node);
    OfTriangles<GroupIndex> as_in_tree;
    std::iota(as_in_tree.begin(), as_in_tree.end(), GroupIndex{0});
    if (count_ > block_size) {
        sort();
    }
    split(0, count_, as_in_tree);
}

/// Returns the nodes that become groups, from left to right.
std::vector<std::uint32_t> find_groups(std::span<const ObbNode> nodes) {
    std::vector<std::uint32_t> groups;
    std::vector<std::uint32_t> stack = {0};
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        if (nodes[node].is_leaf() || nodes[node].triangle_count() <= group_triangles_max) {
            groups.push_back(node);
        } else {
            stack.push_back(nodes[node].right);
            stack.push_back(node + 1);
        }
    }
    return groups;
}

} // namespace

WideLeaves make_wide_leaves(const TreeView& tree, ThreadPool* pool) {
    constexpr std::size_t groups_at_once = 32;
    WideLeaves all;
    all.order.resize(tree.triangles.size());
    for (const std::uint32_t node : find_groups(tree.nodes)) {
        all.groups.push_back({node, 0, 0});
    }
    const std::size_t tasks = (all.groups.size() + groups_at_once - 1) / groups_at_once;
    std::vector<std::vector<WideLeaf>> made(
        tasks); // The leaf numbers of a task's groups count from the task's first leaf.
    parallel_for(pool, tasks, [&](std::size_t task) {
        GroupSplitter splitter(tree);
        const std::span<WideGroup> groups = std::span(all.groups).subspan(task * groups_at_once);
        for (WideGroup& group : groups.first(std::min(groups.size(), groups_at_once))) {
            const ObbNode& node = tree.nodes[group.node];
            group.leaves_begin = static_cast<std::uint32_t>(made[task].size());
            splitter.add_group(
                node,
                std::span(all.order).subspan(node.triangles_begin, node.triangle_count()),
                made[task]);
            group.leaves_end = static_cast<std::uint32_t>(made[task].size());
        }
    });
    for (std::size_t task = 0; task < tasks; ++task) {
        const auto before = static_cast<std::uint32_t>(all.leaves.size());
        all.leaves.insert(all.leaves.end(), made[task].begin(), made[task].end());
        const std::span<WideGroup> groups = std::span(all.groups).subspan(task * groups_at_once);
        for (WideGroup& group : groups.first(std::min(groups.size(), groups_at_once))) {
            group.leaves_begin += before;
            group.leaves_end += before;
        }
    }
    return all;
}

} // namespace cd
