#include "common/tree/obb_tree.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide_tree.hpp"

#include <algorithm>
#include <utility>

namespace cd {

ObbTree::ObbTree(std::shared_ptr<const Mesh> mesh,
                 std::vector<ObbNode> nodes,
                 std::vector<std::uint32_t> triangle_ids,
                 Topology topology)
    : mesh_(std::move(mesh)),
      nodes_(std::move(nodes)),
      triangle_ids_(std::move(triangle_ids)),
      topology_(std::move(topology)) {
    CD_CHECK(!nodes_.empty());
    CD_CHECK(triangle_ids_.size() == mesh_->triangles().size());
    triangles_.reserve(triangle_ids_.size());
    for (const std::uint32_t id : triangle_ids_) {
        triangles_.push_back(mesh_->triangles()[id]);
    }
}

TreeView ObbTree::view() const {
    return {
        nodes_, mesh_->vertices(), triangles_, triangle_ids_, wide_ ? wide_->view() : WideView()};
}

void ObbTree::prepare_search(ThreadPool* pool) {
    wide_ = std::make_shared<const WideTree>(view(), pool);
}

std::uint32_t ObbTree::depth() const {
    // Parents stand before their children.
    std::vector<std::uint32_t> depths(nodes_.size(), 0);
    std::uint32_t deepest = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        deepest = std::max(deepest, depths[i]);
        if (!nodes_[i].is_leaf()) {
            depths[i + 1] = depths[i] + 1;
            depths[nodes_[i].right] = depths[i] + 1;
        }
    }
    return deepest;
}

std::uint64_t ObbTree::memory_bytes() const {
    return nodes_.capacity() * sizeof(ObbNode) + triangle_ids_.capacity() * sizeof(std::uint32_t) +
           triangles_.capacity() * sizeof(Triangle) + mesh_->vertices().size() * sizeof(Vec3) +
           mesh_->triangles().size() * sizeof(Triangle) + (wide_ ? wide_->memory_bytes() : 0);
}

} // namespace cd
