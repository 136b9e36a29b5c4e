#include "master/dispatch/endgame/stragglers.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cd {

double Stragglers::recalls_expired_until() const {
    return context_.pace.now() - timing::recall_answer_seconds;
}

bool Stragglers::can_help(const WorkerProxy& proxy) const {
    return proxy.takes_work() && !proxy.is_claimed() &&
           proxy.tasks.left() < proxy.facts().threads &&
           !tasks_.recalls().is_awaited_by(proxy.id(), recalls_expired_until());
}

std::vector<WorkerProxy*> Stragglers::helpers() const {
    std::vector<WorkerProxy*> found;
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        if (can_help(*proxy)) {
            found.push_back(proxy);
        }
    }
    std::ranges::stable_sort(found, std::greater<>(), [this](const WorkerProxy* proxy) {
        return context_.pace.power_of(*proxy);
    });
    return found;
}

double Stragglers::ends_in(const WorkerProxy& proxy) const {
    const std::uint64_t left = proxy.tasks.left();
    if (left == 0) {
        return 0;
    }
    double seconds = 0; // Time that one thread would need for all tasks of the worker.
    for (const auto& [id, task] : proxy.tasks.all()) {
        if (const DispatchJob* job = context_.queue.find(task.job)) {
            seconds += context_.pace.thread_seconds_of(task, proxy, *job);
        }
    }
    seconds /= static_cast<double>(std::min<std::uint64_t>(left, proxy.facts().threads));
    // A negative value means that the worker is overdue. It is assumed to need as long again.
    return std::abs(std::max(proxy.tasks.progressed(), proxy.transfers_end()) + seconds -
                    context_.pace.now());
}

std::uint64_t Stragglers::positions_to_move(const WorkerProxy& from,
                                            const DispatchJob& job,
                                            const WorkerProxy& helper,
                                            double seconds_here,
                                            double gain) const {
    const double rate_here = context_.pace.positions_per_second(from, job);
    const double rate_there = context_.pace.positions_per_second(helper, job);
    const double begins = ends_in(helper) + timing::end_gain_seconds_min;
    const double one = helper.facts().threads / rate_there + job.missing.any_or(0);
    if (gain * (begins + one) > seconds_here) {
        return 0;
    }
    // Solves for the number of moved positions with which both workers finish together.
    const double count = (seconds_here - begins) / (1 / rate_here + 1 / rate_there);
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(count));
}

std::vector<WorkerProxy*> Stragglers::late() const {
    std::vector<std::pair<double, WorkerProxy*>> late;
    for (WorkerProxy* proxy : context_.pool.in_order()) {
        const double seconds = may_be_helped(*proxy) ? ends_in(*proxy) : 0;
        if (seconds > timing::end_gain_seconds_min) {
            late.emplace_back(seconds, proxy);
        }
    }
    const std::size_t most = std::max(
        limits::late_looked_at_min, context_.pool.in_order().size() / limits::late_looked_at_part);
    if (late.size() > most) {
        std::ranges::stable_sort(
            late, {}, [](const auto& entry) { return entry.second->looked_at(); });
        late.resize(most);
    }
    std::ranges::stable_sort(late, std::greater<>(), &std::pair<double, WorkerProxy*>::first);
    std::vector<WorkerProxy*> workers;
    for (const auto& [seconds, proxy] : late) {
        workers.push_back(proxy);
    }
    return workers;
}

bool Stragglers::may_be_asked(const WorkerProxy& from) const {
    return tasks_.recalls().find(from.id()) == nullptr && from.takes_work();
}

bool Stragglers::may_answer_recall(const WorkerProxy& from) const {
    const PendingRecall* asked = tasks_.recalls().find(from.id());
    return asked != nullptr && from.takes_work() && asked->since > recalls_expired_until();
}

bool Stragglers::may_be_helped(const WorkerProxy& from) const {
    return !may_answer_recall(from) &&
           std::ranges::any_of(from.tasks.all(), [&](const auto& entry) {
               const TaskInFlight& task = entry.second;
               return (may_be_asked(from) && can_be_recalled(task)) || !copyable(task).is_empty();
           });
}

bool Stragglers::is_movable(const TaskInFlight& task) const {
    return task.left() != 0 && !task.is_copy() &&
           (!task.is_analysed || context_.queue.at(task.job).policy->moves_work());
}

bool Stragglers::can_be_recalled(const TaskInFlight& task) const {
    return is_movable(task) && !task.has_begun;
}

PositionSet Stragglers::copyable(const TaskInFlight& task) const {
    if (!is_movable(task)) {
        return {};
    }
    PositionSet positions = task.uncopied();
    if (task.is_analysed) {
        const DispatchJob& job = context_.queue.at(task.job);
        for (const std::uint64_t position : positions.list()) {
            if (!job.at(position).losses.none()) {
                positions.remove({position, 1});
            }
        }
    }
    return positions;
}

} // namespace cd
