#include "client/import/gltf/gltf_trees.hpp"

#include "common/core/limits/client.hpp"

#include <utility>

namespace cd {

namespace {

Error bad(std::size_t node, const std::string& what) {
    return {ErrorCode::BadInput, "node " + std::to_string(node) + ": " + what};
}

Status check_parents(const GltfDocument& document) {
    std::vector<bool> is_child(document.nodes.size(), false);
    for (const GltfNode& node : document.nodes) {
        for (const std::size_t child : node.children) {
            if (is_child[child]) {
                return bad(child, "is the child of two nodes");
            }
            is_child[child] = true;
        }
    }
    std::vector<bool> is_root(document.nodes.size(), false);
    for (const std::size_t root : document.roots) {
        if (is_child[root] || is_root[root]) {
            return bad(root,
                       is_child[root] ? "is a root of the scene and the child of a node"
                                      : "is a root of the scene twice");
        }
        is_root[root] = true;
    }
    return Done{};
}

Status check_depth(const GltfDocument& document) {
    std::vector<std::size_t> level = document.roots;
    for (std::size_t depth = 1; !level.empty(); ++depth) {
        if (depth > limits::mesh_file_depth_max) {
            return bad(level.front(),
                       "is nested more than " + std::to_string(limits::mesh_file_depth_max) +
                           " deep");
        }
        std::vector<std::size_t> next;
        for (const std::size_t node : level) {
            const auto& children = document.nodes[node].children;
            next.insert(next.end(), children.begin(), children.end());
        }
        level = std::move(next);
    }
    return Done{};
}

} // namespace

Status check_gltf_trees(const GltfDocument& document) {
    Status parents = check_parents(document);
    return parents ? check_depth(document) : parents;
}

} // namespace cd
