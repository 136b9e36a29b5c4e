#include "common/tree/subtree.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cd {

namespace {

/// Returns the index after the last node under `node`.
std::uint32_t end_of_subtree(std::span<const ObbNode> nodes, std::uint32_t node) {
    while (!nodes[node].is_leaf()) {
        node = nodes[node].right;
    }
    return node + 1;
}

std::vector<ObbNode> renumbered(std::span<const ObbNode> nodes, std::uint32_t first) {
    const std::uint32_t triangles_first = nodes.front().triangles_begin;
    std::vector<ObbNode> own(nodes.begin(), nodes.end());
    for (ObbNode& node : own) {
        node.right -= node.is_leaf() ? 0 : first;
        node.triangles_begin -= triangles_first;
        node.triangles_end -= triangles_first;
    }
    return own;
}

/// The vertices that a set of triangles uses, in the order of first use; vertices with equal
/// coordinates become one.
struct VertexSelection {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles; ///< Indices into `vertices`.
};

VertexSelection select_vertices(std::span<const Triangle> triangles,
                                std::span<const Vec3> vertices) {
    std::vector<std::uint32_t> used;
    used.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles) {
        used.insert(used.end(), triangle.begin(), triangle.end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());

    const auto key = [&](std::uint32_t vertex) {
        const Vec3& at = vertices[vertex];
        return std::tuple(at.x(), at.y(), at.z());
    };
    std::vector<std::uint32_t> sorted(used.size());
    for (std::uint32_t i = 0; i < used.size(); ++i) {
        sorted[i] = i;
    }
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t left, std::uint32_t right) {
        return key(used[left]) < key(used[right]);
    });
    std::vector<std::uint32_t> rank_of_used(
        used.size()); // Equal for vertices with equal coordinates.
    std::uint32_t ranks = 0;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        ranks += i > 0 && key(used[sorted[i]]) != key(used[sorted[i - 1]]) ? 1 : 0;
        rank_of_used[sorted[i]] = ranks;
    }

    constexpr std::uint32_t not_met = UINT32_MAX;
    std::vector<std::uint32_t> number_of_rank(ranks + 1, not_met);
    VertexSelection selection;
    selection.triangles.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        Triangle own{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = std::lower_bound(used.begin(), used.end(), triangle[i]) - used.begin();
            std::uint32_t& number = number_of_rank[rank_of_used[static_cast<std::size_t>(at)]];
            if (number == not_met) {
                number = static_cast<std::uint32_t>(selection.vertices.size());
                selection.vertices.push_back(vertices[triangle[i]]);
            }
            own[i] = number;
        }
        selection.triangles.push_back(own);
    }
    return selection;
}

std::size_t triangles_in(const WideView& wide) {
    std::size_t triangles = 0;
    for (const WideNode& node : wide.nodes) {
        triangles += node.is_leaf ? node.count : 0;
    }
    return triangles;
}

} // namespace

Subtree::Subtree(std::vector<ObbNode> nodes,
                 std::vector<Vec3> vertices,
                 std::vector<Triangle> triangles,
                 std::vector<std::uint32_t> triangle_ids)
    : nodes_(std::move(nodes)),
      vertices_(std::move(vertices)),
      triangles_(std::move(triangles)),
      triangle_ids_(std::move(triangle_ids)),
      triangle_count_(triangles_.size()) {
    CD_CHECK(!nodes_.empty());
    CD_CHECK(triangles_.size() == triangle_ids_.size());
    CD_CHECK(nodes_.front().triangle_count() == triangles_.size());
}

Subtree::Subtree(WideTree wide)
    : wide_(std::move(wide)), triangle_count_(triangles_in(wide_.view())) {
    CD_CHECK(triangle_count_ > 0);
}

TreeView Subtree::view() const {
    return {nodes_, vertices_, triangles_, triangle_ids_, wide_.view()};
}

std::uint64_t Subtree::memory_bytes() const {
    return sizeof(Subtree) + nodes_.capacity() * sizeof(ObbNode) +
           vertices_.capacity() * sizeof(Vec3) + triangles_.capacity() * sizeof(Triangle) +
           triangle_ids_.capacity() * sizeof(std::uint32_t) + wide_.memory_bytes();
}

Subtree extract_subtree(const ObbTree& tree, std::uint32_t node, SubtreeForm form) {
    const TreeView whole = tree.view();
    CD_CHECK(node < whole.nodes.size());
    const std::uint32_t end = end_of_subtree(whole.nodes, node);
    const ObbNode& root = whole.nodes[node];
    VertexSelection selection = select_vertices(
        whole.triangles.subspan(root.triangles_begin, root.triangle_count()), whole.vertices);
    const auto ids = whole.triangle_ids.subspan(root.triangles_begin, root.triangle_count());
    Subtree binary(renumbered(whole.nodes.subspan(node, end - node), node),
                   std::move(selection.vertices),
                   std::move(selection.triangles),
                   {ids.begin(), ids.end()});
    return form == SubtreeForm::Binary ? std::move(binary)
                                       : Subtree(WideTree::of_part(binary.view()));
}

} // namespace cd
