#include "common/tree/node_check.hpp"

#include "common/tree/build/build_fit.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace cd {

bool is_valid_box(const ObbNode& node) {
    // Comparisons are written so that NaN fails them.
    for (std::size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(node.center[i]) ||
            !(node.half[i] >= std::numeric_limits<float>::min())) {
            return false;
        }
        for (std::size_t j = i; j < 3; ++j) {
            double dot = i == j ? -1.0 : 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                dot += static_cast<double>(node.axes[3 * i + k]) *
                       static_cast<double>(node.axes[3 * j + k]);
            }
            if (!(std::abs(dot) <= axes_error_max)) {
                return false;
            }
        }
    }
    return true;
}

bool is_preorder(std::span<const ObbNode> nodes) {
    // The loop over the preorder keeps one stack entry for each right child still to come.
    std::vector<std::uint32_t> rights;
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (!nodes[i].is_leaf()) {
            if (nodes[i].right >= nodes.size()) {
                return false;
            }
            rights.push_back(nodes[i].right);
            continue;
        }
        // After a leaf comes the right child of the innermost open node, or the end of all nodes.
        const bool is_last = rights.empty();
        if (i + 1 != (is_last ? nodes.size() : rights.back())) {
            return false;
        }
        if (!is_last) {
            rights.pop_back();
        }
    }
    return rights.empty();
}

bool has_consecutive_ranges(std::span<const ObbNode> nodes) {
    if (nodes.front().triangles_begin != 0) {
        return false;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ObbNode& node = nodes[i];
        if (node.triangles_begin >= node.triangles_end) {
            return false;
        }
        if (node.is_leaf()) {
            continue;
        }
        const ObbNode& left = nodes[i + 1];
        const ObbNode& right = nodes[node.right];
        if (left.triangles_begin != node.triangles_begin ||
            right.triangles_begin != left.triangles_end ||
            right.triangles_end != node.triangles_end) {
            return false;
        }
    }
    return true;
}

bool is_tree_over(std::span<const ObbNode> nodes, std::size_t triangles) {
    return !nodes.empty() && is_preorder(nodes) && has_consecutive_ranges(nodes) &&
           nodes.front().triangles_end == triangles;
}

bool is_permutation_of_triangles(std::span<const std::uint32_t> ids, std::size_t triangles) {
    std::vector<bool> seen(triangles, false);
    for (const std::uint32_t id : ids) {
        if (id >= triangles || seen[id]) {
            return false;
        }
        seen[id] = true;
    }
    return ids.size() == triangles;
}

} // namespace cd
