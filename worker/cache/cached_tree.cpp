#include "worker/cache/cached_tree.hpp"

#include "common/core/limits/engine.hpp"
#include "common/core/limits/worker.hpp"

#include <string>
#include <utility>

namespace cd {

Status CachedTree::fill(RootIndex root,
                        std::shared_ptr<const Subtree> subtree,
                        std::shared_ptr<const SubtreeBlock> block) {
    const std::string name = "a block for root " + std::to_string(root);
    if (root >= slots_.size()) {
        return Error{ErrorCode::BadFrame,
                     name + " of a tree with " + std::to_string(slots_.size()) + " roots"};
    }
    if (subtree->form() != named_.form) {
        return Error{ErrorCode::BadFrame, name + " has another form than the tree's"};
    }
    if (partial_.has_top() && subtree->triangle_count() != partial_.top().triangles_under(root)) {
        return Error{ErrorCode::BadFrame,
                     name + " has another number of triangles than the upper tree says"};
    }
    partial_.fill(root, std::move(subtree));
    snapshot_.reset();
    slots_[root].block = std::move(block);
    return Done{};
}

Status CachedTree::set_top(std::shared_ptr<const TreeTop> top,
                           std::shared_ptr<const SubtreeBlock> block) {
    if (top->root_count() != named_.roots || top->triangle_count() != named_.triangles) {
        return Error{ErrorCode::BadFrame,
                     "an upper tree of " + std::to_string(top->root_count()) +
                         " roots for a tree with " + std::to_string(named_.roots)};
    }
    for (RootIndex root = 0; root < named_.roots; ++root) {
        const auto& subtree = partial_.at(root);
        if (subtree != nullptr && subtree->triangle_count() != top->triangles_under(root)) {
            return Error{
                ErrorCode::BadFrame,
                "an upper tree and the block of a root disagree on the number of triangles: root " +
                    std::to_string(root)};
        }
    }
    partial_.set_top(std::move(top));
    snapshot_.reset();
    top_.block = std::move(block);
    return Done{};
}

void CachedTree::empty(RootIndex root) {
    partial_.empty(root);
    snapshot_.reset();
    slots_[root].block.reset();
}

std::shared_ptr<const PartialObbTree> CachedTree::snapshot() {
    if (snapshot_ == nullptr) {
        snapshot_ = std::make_shared<const PartialObbTree>(partial_);
    }
    return snapshot_;
}

std::shared_ptr<const SubtreeBlock> CachedTree::block_at(RootIndex root) const {
    if (root == top_root) {
        return top_.block;
    }
    return root < slots_.size() ? slots_[root].block : nullptr;
}

std::uint64_t CachedTree::bytes_of(RootIndex root) const {
    const auto& block = slots_[root].block;
    return partial_.at(root)->memory_bytes() + (block == nullptr ? 0 : block->compressed.size());
}

std::uint64_t CachedTree::bytes_of_top() const {
    return partial_.has_top() ? partial_.top().nodes.size() * sizeof(ObbNode) +
                                    (top_.block == nullptr ? 0 : top_.block->compressed.size())
                              : 0;
}

std::uint64_t CachedTree::bytes() const {
    std::uint64_t bytes = bytes_of_top();
    for (RootIndex root = 0; root < slots_.size(); ++root) {
        bytes += partial_.at(root) == nullptr ? 0 : bytes_of(root);
    }
    return bytes;
}

std::uint64_t CachedTree::bytes_expected(RootIndex root) const {
    if (root == top_root) {
        return (2ull * named_.roots - 1) * sizeof(ObbNode);
    }
    // All roots of a cut have about the same number of triangles.
    const std::uint64_t triangles = (named_.triangles + named_.roots - 1ull) / named_.roots;
    return triangles * (named_.form == SubtreeForm::Wide ? limits::wide_bytes_per_triangle
                                                         : limits::binary_bytes_per_triangle);
}

} // namespace cd
