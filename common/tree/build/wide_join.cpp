#include "common/tree/build/wide_join.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/wide_boxes.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

namespace cd {

namespace {

constexpr std::size_t children_max = block_size;

float surface(const ObbNode& node) {
    const auto& [x, y, z] = node.half;
    return x * y + y * z + z * x;
}

/// Returns the nodes of the upper tree that become the children of an inner node, from left to
/// right. Repeatedly replaces the inner node with the largest surface by its own children, since a
/// search visits a node about in proportion to its surface.
std::vector<std::uint32_t> children_of(const TreeTop& top, std::uint32_t node) {
    std::vector<std::uint32_t> children{node + 1, top.nodes[node].right};
    const auto opens = [&](std::uint32_t child) {
        return top.nodes[child].is_leaf() ? -1 : surface(top.nodes[child]);
    };
    while (children.size() < children_max) {
        const auto largest = std::ranges::max_element(children, {}, opens);
        const std::uint32_t opened = *largest;
        if (top.nodes[opened].is_leaf()) {
            break;
        }
        *largest = top.nodes[opened].right;
        children.insert(largest, opened + 1);
    }
    return children;
}

template <class To, class From>
void append(std::vector<To>& to, std::span<const From> from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// The arrays of the joined tree.
struct Arrays {
    std::vector<WideNode> nodes;
    std::vector<float> floats;
    std::vector<double> doubles;
    std::vector<std::uint32_t> vertex_begin{0};
    std::vector<BlockCorners> corners;
    std::vector<std::uint32_t> ids;
    double reach = 0;

    void add(const TriangleBlocks& blocks, bool is_double);
    [[nodiscard]] TriangleBlocks view() const {
        return {floats, doubles, vertex_begin, corners, ids, reach};
    }
};

void Arrays::add(const TriangleBlocks& blocks, bool is_double) {
    const std::uint32_t vertices = blocks.vertex_begin.back();
    const std::size_t numbers = 3 * std::size_t{vertices};
    if (!is_double) {
        append(floats, blocks.floats.first(numbers));
    } else if (blocks.floats.empty()) {
        append(doubles, blocks.doubles.first(numbers));
    } else {
        append(doubles, blocks.floats.first(numbers));
    }
    const std::uint32_t before = vertex_begin.back();
    for (const std::uint32_t begin : blocks.vertex_begin.subspan(1)) {
        vertex_begin.push_back(before + begin);
    }
    append(corners, blocks.corners);
    append(ids, blocks.ids);
    reach = std::max(reach, blocks.reach);
}

/// A node of the joined tree above the roots.
struct UpperNode {
    std::uint32_t place = 0; ///< Index in the joined tree.
    std::uint32_t node = 0;  ///< Index in the upper tree.
};

class Joiner {
  public:
    Joiner(const TreeTop& top, std::span<const WideView> subtrees)
        : top_(top), subtrees_(subtrees) {}

    std::shared_ptr<const Arrays> join() {
        place_upper_nodes();
        const bool is_double = std::ranges::any_of(
            subtrees_, [](const WideView& subtree) { return subtree.triangles.floats.empty(); });
        for (RootIndex root = 0; root < subtrees_.size(); ++root) {
            add_subtree(root, is_double);
        }
        if (is_double) {
            arrays_->doubles.resize(arrays_->doubles.size() + spare_numbers, 0);
        } else {
            arrays_->floats.resize(arrays_->floats.size() + spare_numbers, 0);
        }
        const WideBoxes boxes(arrays_->view(), arrays_->nodes);
        for (const UpperNode& upper : upper_) {
            arrays_->nodes[upper.place] = boxes.in_frame(upper.place, top_.nodes[upper.node].axes);
        }
        return std::move(arrays_);
    }

  private:
    /// Assigns places in the joined tree to the nodes above the roots and to the roots.
    void place_upper_nodes();
    /// Appends the nodes and triangles of a subtree, and puts its root in the root's place.
    void add_subtree(RootIndex root, bool is_double);

    const TreeTop& top_;
    std::span<const WideView> subtrees_;
    std::shared_ptr<Arrays> arrays_ = std::make_shared<Arrays>();
    std::vector<UpperNode> upper_;           ///< Each parent before its children.
    std::vector<std::uint32_t> root_places_; ///< Of each root, its index in the joined tree.
};

void Joiner::place_upper_nodes() {
    std::vector<WideNode>& nodes = arrays_->nodes;
    nodes.resize(1);
    root_places_.resize(subtrees_.size(), 0);
    RootIndex root_of_leaf = 0;
    std::vector<RootIndex> root_at(top_.nodes.size(), 0);
    for (const std::uint32_t node : top_.root_nodes) {
        root_at[node] = root_of_leaf++;
    }
    if (!top_.nodes.front().is_leaf()) {
        upper_.push_back({0, 0});
    }
    for (std::size_t i = 0; i < upper_.size(); ++i) {
        const std::vector<std::uint32_t> children = children_of(top_, upper_[i].node);
        const auto first = static_cast<std::uint32_t>(nodes.size());
        nodes[upper_[i].place].first = first;
        nodes[upper_[i].place].count = static_cast<std::uint8_t>(children.size());
        nodes.resize(nodes.size() + children.size());
        for (std::uint32_t k = 0; k < children.size(); ++k) {
            if (top_.nodes[children[k]].is_leaf()) {
                root_places_[root_at[children[k]]] = first + k;
            } else {
                upper_.push_back({first + k, children[k]});
            }
        }
    }
}

void Joiner::add_subtree(RootIndex root, bool is_double) {
    std::vector<WideNode>& nodes = arrays_->nodes;
    const WideView& subtree = subtrees_[root];
    const auto blocks = static_cast<std::uint32_t>(arrays_->vertex_begin.size() - 1);
    // Node i > 0 of the subtree moves to `others` + i; node 0 moves to the root's place.
    const auto others = static_cast<std::uint32_t>(nodes.size()) - 1;
    const auto moved = [&](const WideNode& from) {
        WideNode node = from;
        node.first += node.is_leaf ? blocks : others;
        return node;
    };
    nodes[root_places_[root]] = moved(subtree.nodes.front());
    std::ranges::transform(subtree.nodes.subspan(1), std::back_inserter(nodes), moved);
    arrays_->add(subtree.triangles, is_double);
}

} // namespace

WideTree join_subtrees(const TreeTop& top, std::span<const WideView> subtrees) {
    CD_CHECK(subtrees.size() == top.root_count());
    const std::shared_ptr<const Arrays> arrays = Joiner(top, subtrees).join();
    return {{arrays->nodes, arrays->view(), extent_of(arrays->nodes)}, arrays};
}

} // namespace cd
