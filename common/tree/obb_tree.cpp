#include "common/tree/obb_tree.hpp"

#include "common/core/check.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Owns the arrays of a tree that this process built.
struct BinaryArrays {
    std::vector<ObbNode> nodes;
    std::vector<std::uint32_t> triangle_ids;
    std::vector<Triangle> triangles;
};

BinaryTree
make_binary(const Mesh& mesh, std::vector<ObbNode> nodes, std::vector<std::uint32_t> triangle_ids) {
    CD_CHECK(!nodes.empty());
    CD_CHECK(triangle_ids.size() == mesh.triangles().size());
    auto arrays = std::make_shared<BinaryArrays>();
    arrays->nodes = std::move(nodes);
    arrays->triangle_ids = std::move(triangle_ids);
    arrays->triangles.reserve(arrays->triangle_ids.size());
    for (const std::uint32_t id : arrays->triangle_ids) {
        arrays->triangles.push_back(mesh.triangles()[id]);
    }
    return {arrays->nodes, arrays->triangle_ids, arrays->triangles, arrays};
}

} // namespace

ObbTree::ObbTree(std::shared_ptr<const Mesh> mesh,
                 std::vector<ObbNode> nodes,
                 std::vector<std::uint32_t> triangle_ids,
                 Topology topology)
    : mesh_(std::move(mesh)),
      binary_(make_binary(*mesh_, std::move(nodes), std::move(triangle_ids))),
      topology_(std::move(topology)) {}

ObbTree::ObbTree(std::shared_ptr<const Mesh> mesh,
                 BinaryTree binary,
                 std::shared_ptr<const WideTree> wide,
                 Topology topology)
    : mesh_(std::move(mesh)),
      binary_(std::move(binary)),
      wide_(std::move(wide)),
      topology_(std::move(topology)) {
    CD_CHECK(has_binary() || wide_ != nullptr);
}

std::span<const ObbNode> ObbTree::nodes() const {
    CD_CHECK(has_binary());
    return binary_.nodes;
}

std::span<const std::uint32_t> ObbTree::triangle_ids() const {
    CD_CHECK(has_binary());
    return binary_.triangle_ids;
}

TreeView ObbTree::view() const {
    return {binary_.nodes,
            mesh_->vertices(),
            binary_.triangles,
            binary_.triangle_ids,
            wide_ ? wide_->view() : WideView()};
}

void ObbTree::prepare_search(ThreadPool* pool) {
    CD_CHECK(has_binary());
    wide_ = std::make_shared<const WideTree>(view(), pool);
}

void ObbTree::prepare_planes(ThreadPool* pool) {
    if (wide_ && !wide_->view().nodes.empty() && wide_->view().support.sets.empty()) {
        wide_ = std::make_shared<const WideTree>(wide_->with_support(pool));
    }
}

std::uint32_t ObbTree::depth() const {
    // Parents come before their children.
    const std::span<const ObbNode> all = nodes();
    std::vector<std::uint32_t> depths(all.size(), 0);
    std::uint32_t deepest = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        deepest = std::max(deepest, depths[i]);
        if (!all[i].is_leaf()) {
            depths[i + 1] = depths[i] + 1;
            depths[all[i].right] = depths[i] + 1;
        }
    }
    return deepest;
}

std::uint64_t ObbTree::memory_bytes() const {
    return binary_.nodes.size_bytes() + binary_.triangle_ids.size_bytes() +
           binary_.triangles.size_bytes() + mesh_->vertices().size() * sizeof(Vec3) +
           mesh_->triangles().size() * sizeof(Triangle) + (wide_ ? wide_->memory_bytes() : 0);
}

} // namespace cd
