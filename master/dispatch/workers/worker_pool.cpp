#include "master/dispatch/workers/worker_pool.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>

namespace cd {

namespace {

std::uint64_t block_bytes(const DispatchTree& tree, std::size_t root) {
    return tree.root_bytes.empty() ? tree.root_triangles[root] * limits::block_bytes_per_triangle
                                   : tree.root_bytes[root];
}

} // namespace

WorkerProxy& WorkerPool::add(WorkerId worker, const WorkerFacts& facts) {
    const std::uint32_t slot = free_slot();
    const auto [place, is_new] = proxies_.try_emplace(worker, worker, slot, facts);
    CD_CHECK(is_new);
    slot_taken_[slot] = true;
    const auto before = [](const WorkerProxy* one, WorkerId id) { return one->id() < id; };
    in_order_.insert(std::lower_bound(in_order_.begin(), in_order_.end(), worker, before),
                     &place->second);
    return place->second;
}

std::uint32_t WorkerPool::free_slot() {
    const auto found = std::find(slot_taken_.begin(), slot_taken_.end(), false);
    const auto slot = static_cast<std::uint32_t>(found - slot_taken_.begin());
    if (found == slot_taken_.end()) {
        slot_taken_.push_back(false);
        for (auto& [id, tree] : trees_) {
            tree.held.grow(slot + 1);
            tree.coming.grow(slot + 1);
        }
    }
    return slot;
}

void WorkerPool::remove(WorkerId worker) {
    const std::uint32_t slot = at(worker).slot();
    for (auto& [id, tree] : trees_) {
        tree.held.clear_all(slot);
        tree.coming.clear_all(slot);
    }
    slot_taken_[slot] = false;
    std::erase(in_order_, find(worker));
    proxies_.erase(worker);
}

WorkerProxy* WorkerPool::find(WorkerId worker) {
    const auto found = proxies_.find(worker);
    return found == proxies_.end() ? nullptr : &found->second;
}

const WorkerProxy* WorkerPool::find(WorkerId worker) const {
    const auto found = proxies_.find(worker);
    return found == proxies_.end() ? nullptr : &found->second;
}

WorkerProxy& WorkerPool::at(WorkerId worker) {
    WorkerProxy* proxy = find(worker);
    CD_CHECK(proxy != nullptr);
    return *proxy;
}

const WorkerProxy* WorkerPool::first_that_takes_work() const {
    const auto found = std::ranges::find_if(in_order_, &WorkerProxy::takes_work);
    return found == in_order_.end() ? nullptr : *found;
}

void WorkerPool::add_tree(const DispatchTree& given) {
    CD_CHECK(given.root_bytes.empty() || given.root_bytes.size() == given.root_triangles.size());
    const auto roots = static_cast<std::uint32_t>(given.root_triangles.size());
    const auto slots = static_cast<std::uint32_t>(slot_taken_.size());
    const auto [place, is_new] = trees_.try_emplace(
        given.tree, PooledTree{RootHolders(roots, slots), RootHolders(roots, slots), {}, {}, 0, 0});
    if (!is_new) {
        return;
    }
    PooledTree& tree = place->second;
    tree.triangles = given.root_triangles;
    for (std::size_t root = 0; root < roots; ++root) {
        const std::uint64_t bytes = block_bytes(given, root);
        tree.bytes_64.push_back(static_cast<std::uint32_t>((bytes + PooledTree::bytes_unit - 1) /
                                                           PooledTree::bytes_unit));
        tree.bytes_total += bytes;
        tree.triangles_total += tree.triangles[root];
    }
}

void WorkerPool::remove_tree(TreeId id) {
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
    for (WorkerProxy* proxy : in_order_) {
        proxy->remove_held(sums[proxy->slot()]);
    }
    trees_.erase(found);
}

const PooledTree& WorkerPool::tree(TreeId id) const {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    return found->second;
}

WorkerPool::Missing
WorkerPool::hold(WorkerProxy& proxy, TreeId id, std::span<const WeightedRoot> roots) {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    Missing missing;
    for (const WeightedRoot& root : roots) {
        hold_root(proxy, found->second, root.root, missing);
    }
    return missing;
}

WorkerPool::Missing
WorkerPool::hold(WorkerProxy& proxy, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    CD_CHECK(found != trees_.end());
    Missing missing;
    for (const RootIndex root : roots) {
        hold_root(proxy, found->second, root, missing);
    }
    return missing;
}

void WorkerPool::hold_root(WorkerProxy& proxy, PooledTree& tree, RootIndex root, Missing& missing) {
    CD_CHECK(root < tree.triangles.size());
    if (tree.held.set(proxy.slot(), root)) {
        tree.coming.set(proxy.slot(), root);
        proxy.add_held(tree.triangles[root]);
        missing.roots.push_back(root);
        missing.bytes += tree.bytes_of(root);
    }
}

void WorkerPool::arrived(const WorkerProxy& proxy, TreeId id, std::span<const WeightedRoot> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end() || !found->second.coming.any()) {
        return;
    }
    for (const WeightedRoot& root : roots) {
        found->second.coming.clear(proxy.slot(), root.root);
    }
}

void WorkerPool::arrived(const WorkerProxy& proxy, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    for (const RootIndex root : roots) {
        if (root < found->second.triangles.size()) {
            found->second.coming.clear(proxy.slot(), root);
        }
    }
}

void WorkerPool::release(WorkerProxy& proxy, TreeId id, std::span<const RootIndex> roots) {
    const auto found = trees_.find(id);
    if (found == trees_.end()) {
        return;
    }
    PooledTree& tree = found->second;
    for (const RootIndex root : roots) {
        if (root < tree.triangles.size() && tree.held.clear(proxy.slot(), root)) {
            tree.coming.clear(proxy.slot(), root);
            proxy.remove_held(tree.triangles[root]);
        }
    }
}

void WorkerPool::check() const {
    std::vector<bool> taken(slot_taken_.size(), false);
    CD_CHECK(in_order_.size() == proxies_.size());
    auto next = in_order_.begin();
    for (const auto& [id, proxy] : proxies_) {
        CD_CHECK(*next++ == &proxy);
        CD_CHECK(slot_taken_.at(proxy.slot()));
        CD_CHECK(!taken[proxy.slot()]);
        taken[proxy.slot()] = true;
        std::uint64_t triangles = 0;
        for (const auto& [tree_id, tree] : trees_) {
            for (RootIndex root = 0; root < tree.triangles.size(); ++root) {
                triangles += tree.held.holds(proxy.slot(), root) ? tree.triangles[root] : 0;
            }
        }
        CD_CHECK(triangles == proxy.held_triangles());
    }
    CD_CHECK(taken == slot_taken_);
    for (const auto& [id, tree] : trees_) {
        check_tree(tree);
    }
}

void WorkerPool::check_tree(const PooledTree& tree) const {
    CD_CHECK(tree.held.holder_count() == slot_taken_.size());
    CD_CHECK(tree.coming.holder_count() == slot_taken_.size());
    for (RootIndex root = 0; root < tree.triangles.size(); ++root) {
        std::uint32_t holders = 0;
        for (std::uint32_t slot = 0; slot < slot_taken_.size(); ++slot) {
            const bool is_held = tree.held.holds(slot, root);
            CD_CHECK(!is_held || slot_taken_[slot]);
            CD_CHECK(is_held || !tree.coming.holds(slot, root));
            holders += is_held ? 1 : 0;
        }
        CD_CHECK(holders == tree.held.holders_of(root));
    }
}

} // namespace cd
