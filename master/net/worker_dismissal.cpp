#include "master/net/worker_dismissal.hpp"

#include "master/coordinator/coordinator.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cd {

Result<Draining> dismiss_workers(Coordinator& coordinator, DrainWorkers wish) {
    const std::vector<WorkerId> here = coordinator.workers_here();
    std::vector<WorkerId> told = wish.workers.empty() ? here : std::move(wish.workers);
    std::ranges::sort(told);
    told.erase(std::ranges::unique(told).begin(), told.end());
    for (const WorkerId worker : told) {
        if (!std::ranges::binary_search(here, worker)) {
            return Error{ErrorCode::NotFound,
                         "no worker w-" + std::to_string(worker.value) + " is here"};
        }
    }
    for (const WorkerId worker : told) {
        if (wish.now) {
            coordinator.terminate_worker(worker);
        } else {
            coordinator.drain_worker(worker);
        }
    }
    return Draining{std::move(told)};
}

} // namespace cd
