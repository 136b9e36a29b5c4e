#include "client/trees/body_trees.hpp"

#include "common/tree/build/build.hpp"
#include "common/tree/wide/wide_tree.hpp"

#include <algorithm>
#include <map>
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

std::vector<std::shared_ptr<const ObbTree>>
make_body_trees(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                const TreeUse& use,
                TreeCache& cache,
                ThreadPool& pool) {
    std::vector<Body> distinct;
    std::map<Sha256, std::size_t> numbers;
    std::vector<std::size_t> number_of; // For each body, that of its mesh.
    for (const auto& mesh : meshes) {
        const auto [known, is_new] = numbers.try_emplace(mesh->hash(), distinct.size());
        if (is_new) {
            distinct.emplace_back(mesh, cache, pool);
        }
        number_of.push_back(known->second);
    }
    std::ranges::for_each(distinct, &Body::need_wide);
    for (Body& body : distinct) {
        body.need_points(use.makes_points);
    }
    const auto closed = std::ranges::count_if(
        number_of, [&](std::size_t number) { return distinct[number].is_closed(); });
    // A search uses the binary trees if a body has no wide nodes.
    const bool all_need_binary = !std::ranges::all_of(distinct, &Body::has_wide_nodes);
    for (Body& body : distinct) {
        if (all_need_binary || (use.settles && closed >= 2 && body.is_closed())) {
            body.need_binary();
        }
    }
    std::vector<std::shared_ptr<const ObbTree>> made;
    for (const Body& body : distinct) {
        made.push_back(body.tree());
    }
    std::vector<std::shared_ptr<const ObbTree>> trees;
    for (const std::size_t number : number_of) {
        trees.push_back(made[number]);
    }
    return trees;
}

} // namespace cd
