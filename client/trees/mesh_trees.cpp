#include "client/trees/mesh_trees.hpp"

#include "common/tree/build/build.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <utility>

namespace cd {

void MeshTrees::need_wide(TreeCache& cache, ThreadPool& pool, const StopCheck& stop) {
    if (wide_) {
        return;
    }
    wide_ = cache.find(TreeForm::Wide, mesh_);
    if (wide_) {
        return;
    }
    binary_ = cache.find(TreeForm::Binary, mesh_);
    if (binary_) {
        ObbTree tree = *binary_;
        tree.prepare_search(&pool);
        wide_ = std::make_shared<const ObbTree>(std::move(tree));
    } else {
        auto built = build_tree_until(stop, mesh_, {}, pool);
        if (!built) {
            return;
        }
        wide_ = std::make_shared<const ObbTree>(std::move(*built));
    }
    cache.keep(TreeForm::Wide, *wide_);
}

void MeshTrees::need_points(bool makes_them, TreeCache& cache, ThreadPool& pool) {
    if (!has_wide_nodes() || has_points()) {
        return;
    }
    if (auto cached = cache.find_points(*wide_)) {
        wide_ = std::move(cached);
    } else if (makes_them) {
        ObbTree tree = *wide_;
        tree.prepare_planes(&pool);
        wide_ = std::make_shared<const ObbTree>(std::move(tree));
        cache.keep_points(*wide_);
    }
}

void MeshTrees::need_binary(TreeCache& cache, ThreadPool& pool) {
    shows_binary_ = true;
    if (binary_) {
        return;
    }
    if (wide_ && wide_->has_binary()) {
        binary_ = wide_;
        cache.keep(TreeForm::Binary, *binary_);
        return;
    }
    binary_ = cache.find(TreeForm::Binary, mesh_);
    if (!binary_) {
        BuildOptions options;
        options.prepare_search = false;
        binary_ = std::make_shared<const ObbTree>(build_tree(mesh_, options, pool));
        cache.keep(TreeForm::Binary, *binary_);
    }
}

bool MeshTrees::has_wide_nodes() const {
    return wide_ && !wide_->wide()->view().nodes.empty();
}

bool MeshTrees::has_points() const {
    return has_wide_nodes() && !wide_->wide()->view().support.sets.empty();
}

std::shared_ptr<const ObbTree> MeshTrees::tree() const {
    return std::make_shared<const ObbTree>(mesh_,
                                           shows_binary_ ? binary_->binary() : BinaryTree{},
                                           wide_ ? wide_->wide() : nullptr,
                                           any().topology());
}

} // namespace cd
