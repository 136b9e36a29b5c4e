#include "master/jobs/feed/lease_book.hpp"

#include "common/core/check.hpp"

#include <algorithm>

namespace cd {

void LeaseBook::add(WorkerId worker, TaskId task, Lease lease) {
    const bool is_new = leases_.emplace(std::pair(worker, task), std::move(lease)).second;
    CD_CHECK(is_new);
}

Lease* LeaseBook::find(WorkerId worker, TaskId task) {
    const auto found = leases_.find({worker, task});
    return found == leases_.end() ? nullptr : &found->second;
}

void LeaseBook::forget(WorkerId worker) {
    std::erase_if(leases_, [&](const auto& lease) { return lease.first.first == worker; });
}

std::vector<TaskId> LeaseBook::missing(WorkerId worker, std::span<const Recalled> present) const {
    std::vector<TaskId> missing;
    for (auto lease = leases_.lower_bound({worker, TaskId{}});
         lease != leases_.end() && lease->first.first == worker;
         ++lease) {
        const TaskId task = lease->first.second;
        if (std::ranges::find(present, task, &Recalled::task) == present.end()) {
            missing.push_back(task);
        }
    }
    return missing;
}

} // namespace cd
