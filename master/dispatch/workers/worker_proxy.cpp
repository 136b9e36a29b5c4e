#include "master/dispatch/workers/worker_proxy.hpp"

#include <algorithm>

namespace cd {

std::size_t WorkerProxy::tasks_max(const ClusterOptions& options) const {
    const std::size_t q = std::max(options.q, 1u);
    const std::size_t working = (std::size_t{facts_.threads} + q - 1) / q;
    return 1 + std::max<std::size_t>(working, 1);
}

bool WorkerProxy::would_run_dry(const ClusterOptions& options) const {
    return tasks.left() < std::max<std::uint64_t>(options.q, 2 * std::uint64_t{facts_.threads});
}

void WorkerProxy::add_transfer(double now, double seconds) {
    transfers_end_ = std::max(transfers_end_, now) + seconds;
}

WorkerStatus WorkerProxy::status() const {
    WorkerStatus status;
    status.worker = id_;
    status.name = facts_.name;
    status.threads = facts_.threads;
    status.claimed = is_claimed();
    status.draining = draining_;
    status.buffered = buffers.count();
    status.working = tasks.left();
    status.tasks = tasks.sent();
    status.scenarios = tasks.answered();
    return status;
}

} // namespace cd
