#include "client/trees/body_trees.hpp"

#include "common/tree/build/build.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace cd {

namespace {

/// One body's tree, whose wide and binary forms are made on demand.
class Body {
  public:
    Body(std::shared_ptr<const Mesh> mesh, TreeCache& cache, ThreadPool& pool)
        : mesh_(std::move(mesh)), cache_(cache), pool_(pool) {}

    void need_wide() {
        wide_ = cache_.find(TreeForm::Wide, mesh_);
        if (wide_) {
            return;
        }
        binary_ = cache_.find(TreeForm::Binary, mesh_);
        if (binary_) {
            ObbTree tree = *binary_;
            tree.prepare_search(&pool_);
            wide_ = std::make_shared<const ObbTree>(std::move(tree));
        } else {
            wide_ = std::make_shared<const ObbTree>(build_tree(mesh_, {}, pool_));
        }
        cache_.keep(TreeForm::Wide, *wide_);
    }

    /// Adds support points to the wide form, if it has nodes.
    void need_points(bool makes_them) {
        if (!has_wide_nodes()) {
            return;
        }
        if (auto cached = cache_.find_points(*wide_)) {
            wide_ = std::move(cached);
        } else if (makes_them) {
            ObbTree tree = *wide_;
            tree.prepare_planes(&pool_);
            wide_ = std::make_shared<const ObbTree>(std::move(tree));
            cache_.keep_points(*wide_);
        }
    }

    void need_binary() {
        shows_binary_ = true;
        if (binary_) {
            return;
        }
        if (wide_ && wide_->has_binary()) {
            binary_ = wide_;
            cache_.keep(TreeForm::Binary, *binary_);
            return;
        }
        binary_ = cache_.find(TreeForm::Binary, mesh_);
        if (!binary_) {
            BuildOptions options;
            options.prepare_search = false;
            binary_ = std::make_shared<const ObbTree>(build_tree(mesh_, options, pool_));
            cache_.keep(TreeForm::Binary, *binary_);
        }
    }

    [[nodiscard]] bool is_closed() const { return any().topology().is_closed(); }
    [[nodiscard]] bool has_wide_nodes() const {
        return wide_ && !wide_->wide()->view().nodes.empty();
    }

    /// Returns the tree in the forms that `need_wide` and `need_binary` have made.
    [[nodiscard]] std::shared_ptr<const ObbTree> tree() const {
        return std::make_shared<const ObbTree>(mesh_,
                                               shows_binary_ ? binary_->binary() : BinaryTree{},
                                               wide_ ? wide_->wide() : nullptr,
                                               any().topology());
    }

  private:
    [[nodiscard]] const ObbTree& any() const { return wide_ ? *wide_ : *binary_; }

    std::shared_ptr<const Mesh> mesh_;
    TreeCache& cache_;
    ThreadPool& pool_;
    std::shared_ptr<const ObbTree> wide_;   ///< Has the wide form; null until requested.
    std::shared_ptr<const ObbTree> binary_; ///< Has the binary form; may be set without a request.
    bool shows_binary_ = false;
};

} // namespace

std::array<std::shared_ptr<const ObbTree>, 2>
make_body_trees(const std::array<std::shared_ptr<const Mesh>, 2>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool) {
    std::vector<Body> bodies;
    bodies.emplace_back(meshes[0], cache, pool);
    if (meshes[1]->hash() != meshes[0]->hash()) {
        bodies.emplace_back(meshes[1], cache, pool);
    }
    std::ranges::for_each(bodies, &Body::need_wide);
    for (Body& body : bodies) {
        body.need_points(use.makes_points);
    }
    // A search uses the binary trees if a body has no wide nodes.
    if (!std::ranges::all_of(bodies, &Body::has_wide_nodes) ||
        (use.settles && std::ranges::all_of(bodies, &Body::is_closed))) {
        std::ranges::for_each(bodies, &Body::need_binary);
    }
    const auto first = bodies.front().tree();
    return {first, bodies.size() == 1 ? first : bodies.back().tree()};
}

} // namespace cd
