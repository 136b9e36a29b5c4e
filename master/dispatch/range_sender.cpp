#include "master/dispatch/range_sender.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <algorithm>

namespace cd {

std::uint64_t RangeSender::enough(const DispatchJob& job) const {
    RangeTotals& of_all = totals(job);
    if (!of_all.enough) {
        std::uint64_t enough = 0;
        for (const WorkerProxy* proxy : context_.pool.in_order()) {
            enough += proxy->takes_work() ? positions_at_once(*proxy, job) : 0;
        }
        of_all.enough = enough;
    }
    return *of_all.enough;
}

void RangeSender::forget_totals() const {
    for (const auto& [id, job] : queue_.jobs()) {
        job.range_totals.reset();
    }
}

void RangeSender::age_totals() const {
    for (const auto& [id, job] : queue_.jobs()) {
        if (job.range_totals && --job.range_totals->events_left == 0) {
            job.range_totals.reset();
        }
    }
}

RangeTotals& RangeSender::totals(const DispatchJob& job) const {
    if (job.range_totals) {
        return *job.range_totals;
    }
    RangeTotals totals;
    totals.left = job.unsent.rest();
    for (const WorkerProxy* proxy : context_.pool.in_order()) {
        if (!proxy->takes_work()) {
            continue;
        }
        const double rate = context_.pace.positions_per_second(*proxy, job);
        totals.rate += rate;
        if (proxy->is_claimed()) {
            continue;
        }
        totals.unclaimed += rate;
        totals.left += proxy->tasks.left();
        const double of_thread = rate / proxy->facts().threads;
        totals.quickest_but = std::max(totals.quickest_but, std::min(of_thread, totals.quickest));
        if (of_thread > totals.quickest) {
            totals.quickest = of_thread;
            totals.quickest_worker = proxy->id();
        }
    }
    // The size of a range depends on the number of scenarios left. Near the job's end that number
    // changes quickly, so the totals are counted at each event.
    const std::size_t workers = context_.pool.in_order().size();
    const std::uint64_t left = totals.left / std::max<std::size_t>(1, workers);
    totals.events_left = std::max<std::size_t>(
        1, std::min(workers / limits::workers_per_event, left / limits::scenarios_left_per_event));
    return job.range_totals.emplace(totals);
}

bool RangeSender::would_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    // The next range goes out before the worker has finished the current one.
    return may_take(proxy, job) && proxy.tasks.count_of(job.id) < limits::batches_at_worker &&
           proxy.tasks.left_of(job.id) < positions_at_once(proxy, job);
}

bool RangeSender::has_range_for(const WorkerProxy& proxy, const DispatchJob& job) const {
    return !job.unsent.is_empty() && proxy.takes_work() && !proxy.is_claimed() &&
           &proxy != context_.reserved() && !would_be_late(proxy, job);
}

bool RangeSender::may_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    const std::size_t tasks_max =
        std::max<std::size_t>(limits::batches_at_worker, proxy.facts().threads);
    return proxy.tasks.unanswered_of(job.id) < tasks_max && has_range_for(proxy, job);
}

bool RangeSender::would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const {
    const RangeTotals& of_all = totals(job);
    const bool is_quickest = of_all.quickest_worker == proxy.id();
    const double quickest = is_quickest ? of_all.quickest_but : of_all.quickest;
    if (quickest <= 0) {
        return false;
    }
    // Compares the time of one scenario on this worker with the time that the others need for all.
    const double rate = context_.pace.positions_per_second(proxy, job);
    const double others = std::max(of_all.unclaimed - rate, quickest);
    // The totals are some events old, and the worker may have got tasks since.
    const auto left = static_cast<double>(of_all.left - std::min(of_all.left, proxy.tasks.left()));
    return proxy.facts().threads / rate >
           limits::range_lateness_max * std::max(left / others, 1 / quickest);
}

std::uint64_t RangeSender::positions_at_once(const WorkerProxy& proxy,
                                             const DispatchJob& job) const {
    const double rate = context_.pace.positions_per_second(proxy, job);
    const double all = totals(job).rate;
    const double left = static_cast<double>(job.unsent.rest());
    // Half of the worker's share of all unsent scenarios, so that later ranges even out errors.
    const double share = all > 0 ? left * rate / all / 2 : left;
    const double most = std::min(proxy.batch.seconds() * rate, share);
    return static_cast<std::uint64_t>(std::clamp(most,
                                                 static_cast<double>(proxy.facts().threads),
                                                 static_cast<double>(limits::range_scenarios_max)));
}

void RangeSender::send(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    const GivenRange sent = job.unsent.take_first(positions_at_once(proxy, job));
    tasks_.send_range(proxy, job, sent, context_.pace.position_ns(proxy, job), actions);
}

} // namespace cd
