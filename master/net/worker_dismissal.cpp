#include "master/net/worker_dismissal.hpp"

#include "master/coordinator/coordinator.hpp"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <string>
#include <vector>

namespace cd {

Result<Draining> dismiss_workers(Coordinator& coordinator, DrainWorkers wish) {
    const WorkerDirectory::Workers& here = coordinator.workers().all();
    std::vector<WorkerId> told = std::move(wish.workers);
    if (told.empty()) {
        std::ranges::copy(std::views::keys(here), std::back_inserter(told));
    }
    std::ranges::sort(told);
    told.erase(std::ranges::unique(told).begin(), told.end());
    for (const WorkerId worker : told) {
        if (!here.contains(worker)) {
            return Error{ErrorCode::NotFound,
                         "no worker w-" + std::to_string(worker.value) + " is here"};
        }
    }
    for (const WorkerId worker : told) {
        if (wish.now) {
            coordinator.worker_desk().terminate(worker);
        } else {
            coordinator.worker_desk().drain(worker);
        }
    }
    return Draining{std::move(told)};
}

} // namespace cd
