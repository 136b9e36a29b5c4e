#include "master/dispatch/blocks/block_plan.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

namespace cd {

namespace {

std::uint64_t block_bytes(const DispatchTree& tree, std::size_t root) {
    return tree.root_bytes.empty() ? tree.root_triangles[root] * limits::block_bytes_per_triangle
                                   : tree.root_bytes[root];
}

} // namespace

// ---- Workers ------------------------------------------------------------------------------------

void BlockPlan::join(std::uint32_t slot) {
    if (slot < held_triangles_.size()) {
        return;
    }
    held_triangles_.resize(slot + 1, 0);
    for (auto& [id, tree] : trees_) {
        tree.held.grow(slot + 1);
        tree.coming.grow(slot + 1);
    }
}

void BlockPlan::leave(std::uint32_t slot) {
    for (auto& [id, tree] : trees_) {
        tree.held.clear_all(slot);
        tree.coming.clear_all(slot);
    }
    held_triangles_.at(slot) = 0;
}

// ---- Trees --------------------------------------------------------------------------------------

void BlockPlan::add_tree(const DispatchTree& given) {
    CD_CHECK(given.root_bytes.empty() || given.root_bytes.size() == given.root_triangles.size());
    const auto roots = static_cast<std::uint32_t>(given.root_triangles.size());
    const auto slots = static_cast<std::uint32_t>(held_triangles_.size());
    const auto [place, is_new] = trees_.try_emplace(
        given.tree,
        PlannedTree{RootHolders(roots, slots), RootHolders(roots, slots), {}, {}, 0, 0});
    if (!is_new) {
        return;
    }
    PlannedTree& tree = place->second;
    tree.triangles = given.root_triangles;
    for (std::size_t root = 0; root < roots; ++root) {
        const std::uint64_t bytes = block_bytes(given, root);
        tree.bytes_64.push_back(static_cast<std::uint32_t>((bytes + PlannedTree::bytes_unit - 1) /
                                                           PlannedTree::bytes_unit));
        tree.bytes_total += bytes;
        tree.triangles_total += tree.triangles[root];
    }
}

void BlockPlan::remove_tree(TreeId id) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    std::vector<WeightedRoot> roots;
    for (RootIndex root = 0; root < found->second.triangles.size(); ++root) {
        roots.push_back({root, found->second.triangles[root]});
    }
    std::vector<std::uint64_t> sums(found->second.held.sum_count(), 0);
    found->second.held.add_held(roots, sums);
    for (std::size_t slot = 0; slot < held_triangles_.size(); ++slot) {
        held_triangles_[slot] -= sums[slot];
    }
    trees_.erase(found);
}

const PlannedTree& BlockPlan::tree(TreeId id) const {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    return found->second;
}

// ---- Blocks -------------------------------------------------------------------------------------

BlockPlan::Missing
BlockPlan::hold(std::uint32_t slot, TreeId id, std::span<const WeightedRoot> roots) {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    Missing missing{id, {}, 0};
    for (const WeightedRoot& root : roots) {
        hold_root(slot, found->second, root.root, missing);
    }
    return missing;
}

BlockPlan::Missing
BlockPlan::hold(std::uint32_t slot, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    Missing missing{id, {}, 0};
    for (const RootIndex root : roots) {
        hold_root(slot, found->second, root, missing);
    }
    return missing;
}

void BlockPlan::hold_root(std::uint32_t slot, PlannedTree& tree, RootIndex root, Missing& missing) {
    CD_CHECK(root < tree.triangles.size());
    if (tree.held.set(slot, root)) {
        tree.coming.set(slot, root);
        held_triangles_[slot] += tree.triangles[root];
        missing.roots.push_back(root);
        missing.bytes += tree.bytes_of(root);
    }
}

void BlockPlan::arrived(std::uint32_t slot, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    PlannedTree& tree = found->second;
    for (const RootIndex root : roots) {
        if (root >= tree.triangles.size()) {
            continue;
        }
        if (tree.held.set(slot, root)) {
            held_triangles_[slot] += tree.triangles[root];
        }
        tree.coming.clear(slot, root);
    }
}

void BlockPlan::arrived(std::uint32_t slot, TreeId id, std::span<const WeightedRoot> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end() || !found->second.coming.any()) {
        return;
    }
    for (const WeightedRoot& root : roots) {
        found->second.coming.clear(slot, root.root);
    }
}

void BlockPlan::release(std::uint32_t slot, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    PlannedTree& tree = found->second;
    for (const RootIndex root : roots) {
        if (root < tree.triangles.size() && tree.held.clear(slot, root)) {
            tree.coming.clear(slot, root);
            held_triangles_[slot] -= tree.triangles[root];
        }
    }
}

// ---- Check --------------------------------------------------------------------------------------

void BlockPlan::check(const std::vector<bool>& taken) const {
    CD_CHECK(taken.size() == held_triangles_.size());
    std::vector<std::uint64_t> sums(taken.size(), 0);
    for (const auto& [id, tree] : trees_) {
        check_tree(tree, taken, sums);
    }
    CD_CHECK(sums == held_triangles_);
}

void BlockPlan::check_tree(const PlannedTree& tree,
                           const std::vector<bool>& taken,
                           std::vector<std::uint64_t>& sums) {
    CD_CHECK(tree.held.holder_count() == taken.size());
    CD_CHECK(tree.coming.holder_count() == taken.size());
    for (RootIndex root = 0; root < tree.triangles.size(); ++root) {
        std::uint32_t holders = 0;
        for (std::uint32_t slot = 0; slot < taken.size(); ++slot) {
            const bool is_held = tree.held.holds(slot, root);
            CD_CHECK(!is_held || taken[slot]);
            CD_CHECK(is_held || !tree.coming.holds(slot, root));
            holders += is_held ? 1 : 0;
            sums[slot] += is_held ? tree.triangles[root] : 0;
        }
        CD_CHECK(holders == tree.held.holders_of(root));
    }
}

} // namespace cd
