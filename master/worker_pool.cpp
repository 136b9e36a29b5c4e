#include "master/worker_pool.hpp"

#include "common/core/check.hpp"

#include <algorithm>

namespace cd {

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
        for (auto& [tree, holders] : holders_) {
            holders.grow(static_cast<std::uint32_t>(slot_taken_.size()));
        }
    }
    return slot;
}

void WorkerPool::remove(WorkerId worker) {
    const std::uint32_t slot = at(worker).slot();
    for (auto& [tree, holders] : holders_) {
        holders.clear_all(slot);
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

void WorkerPool::add_tree(TreeId tree, std::uint32_t root_count) {
    holders_.try_emplace(tree, root_count, static_cast<std::uint32_t>(slot_taken_.size()));
}

const RootHolders& WorkerPool::holders(TreeId tree) const {
    const auto found = holders_.find(tree);
    CD_CHECK(found != holders_.end());
    return found->second;
}

void WorkerPool::hold(const WorkerProxy& proxy, TreeId tree, std::span<const WeightedRoot> roots) {
    const auto found = holders_.find(tree);
    CD_CHECK(found != holders_.end());
    for (const WeightedRoot& root : roots) {
        CD_CHECK(root.root < found->second.root_count());
        found->second.set(proxy.slot(), root.root);
    }
}

void WorkerPool::release(const WorkerProxy& proxy, TreeId tree, std::span<const RootIndex> roots) {
    const auto found = holders_.find(tree);
    if (found == holders_.end()) {
        return;
    }
    for (const RootIndex root : roots) {
        if (root < found->second.root_count()) {
            found->second.clear(proxy.slot(), root);
        }
    }
}

void WorkerPool::check_slots() const {
    std::vector<bool> taken(slot_taken_.size(), false);
    for (const auto& [id, proxy] : proxies_) {
        CD_CHECK(slot_taken_.at(proxy.slot()));
        CD_CHECK(!taken[proxy.slot()]);
        taken[proxy.slot()] = true;
    }
    CD_CHECK(taken == slot_taken_);
    CD_CHECK(in_order_.size() == proxies_.size());
    auto next = in_order_.begin();
    for (const auto& [id, proxy] : proxies_) {
        CD_CHECK(*next++ == &proxy);
    }
    for (const auto& [tree, holders] : holders_) {
        CD_CHECK(holders.holder_count() == slot_taken_.size());
        for (std::uint32_t slot = 0; slot < holders.holder_count(); ++slot) {
            for (RootIndex root = 0; !taken[slot] && root < holders.root_count(); ++root) {
                CD_CHECK(!holders.holds(slot, root));
            }
        }
    }
}

} // namespace cd
