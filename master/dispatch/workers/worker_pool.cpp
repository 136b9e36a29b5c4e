#include "master/dispatch/workers/worker_pool.hpp"

#include "common/core/check.hpp"
#include "common/core/timing/master.hpp"

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
    }
    return slot;
}

void WorkerPool::remove(WorkerId worker) {
    slot_taken_[at(worker).slot()] = false;
    std::erase(in_order_, find(worker));
    proxies_.erase(worker);
}

double WorkerPool::message_seconds() const {
    const double seconds = timing::message_seconds_each * static_cast<double>(in_order_.size());
    return std::min(seconds, timing::message_seconds_max);
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

void WorkerPool::check() const {
    std::vector<bool> taken(slot_taken_.size(), false);
    CD_CHECK(in_order_.size() == proxies_.size());
    auto next = in_order_.begin();
    for (const auto& [id, proxy] : proxies_) {
        CD_CHECK(*next++ == &proxy);
        CD_CHECK(slot_taken_.at(proxy.slot()));
        CD_CHECK(!taken[proxy.slot()]);
        taken[proxy.slot()] = true;
    }
    CD_CHECK(taken == slot_taken_);
}

} // namespace cd
