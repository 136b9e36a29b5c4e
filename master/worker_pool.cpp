#include "master/worker_pool.hpp"

#include "common/core/check.hpp"

namespace cd {

WorkerProxy& WorkerPool::add(WorkerId worker, const WorkerFacts& facts) {
    const auto [place, is_new] = proxies_.try_emplace(worker, worker, facts);
    CD_CHECK(is_new);
    return place->second;
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
    for (auto& [id, proxy] : proxies_) {
        proxy.add_tree(tree, root_count);
    }
}

void WorkerPool::remove_tree(TreeId tree) {
    for (auto& [id, proxy] : proxies_) {
        proxy.remove_tree(tree);
    }
}

} // namespace cd
