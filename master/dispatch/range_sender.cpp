#include "master/dispatch/range_sender.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <algorithm>

namespace cd {

namespace {

/// Returns the number of positions in a range for the worker, of which it should have `wanted`.
std::uint64_t bounded_positions(double wanted, const WorkerProxy& proxy) {
    return static_cast<std::uint64_t>(std::clamp(wanted,
                                                 static_cast<double>(proxy.facts().threads),
                                                 static_cast<double>(limits::range_scenarios_max)));
}

} // namespace

std::uint64_t RangeSender::enough(const DispatchJob& job) const {
    const RangeTotals& of_all = totals(job);
    const std::uint64_t share = job.unsent.rest() / 2; // Sum of the workers' shares.
    return std::max(of_all.threads, std::min(of_all.at_once, share));
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

const RangeTotals& RangeSender::totals(const DispatchJob& job) const {
    if (job.range_totals) {
        return *job.range_totals;
    }
    RangeTotals totals;
    for (const WorkerProxy* proxy : context_.pool.in_order()) {
        if (!proxy->takes_work()) {
            continue;
        }
        const double rate = context_.pace.positions_per_second(*proxy, job);
        totals.rate += rate;
        totals.threads += proxy->facts().threads;
        totals.at_once += bounded_positions(range_seconds(*proxy) * rate, *proxy);
        if (proxy->is_claimed()) {
            continue;
        }
        totals.unclaimed += rate;
        totals.in_flight += proxy->tasks.left();
        const double of_thread = rate / proxy->facts().threads;
        totals.quickest_but = std::max(totals.quickest_but, std::min(of_thread, totals.quickest));
        if (of_thread > totals.quickest) {
            totals.quickest = of_thread;
            totals.quickest_worker = proxy->id();
        }
    }
    totals.events_left =
        std::max<std::size_t>(1, context_.pool.in_order().size() / limits::workers_per_event);
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
    const std::uint64_t in_flight =
        of_all.in_flight - std::min(of_all.in_flight, proxy.tasks.left());
    const auto left = static_cast<double>(job.unsent.rest() + in_flight);
    return proxy.facts().threads / rate >
           limits::range_lateness_max * std::max(left / others, 1 / quickest);
}

double RangeSender::range_seconds(const WorkerProxy& proxy) const {
    return std::max(proxy.batch.seconds(), context_.pool.message_seconds());
}

std::uint64_t RangeSender::positions_at_once(const WorkerProxy& proxy,
                                             const DispatchJob& job) const {
    const double rate = context_.pace.positions_per_second(proxy, job);
    const double all = totals(job).rate;
    const double left = static_cast<double>(job.unsent.rest());
    // Half of the worker's share of all unsent scenarios, so that later ranges even out errors. A
    // range shorter than a round trip would leave the worker idle until the next one.
    const double share = all > 0 ? left * rate / all / 2 : left;
    const double least = proxy.batch.seconds_least() * rate;
    return bounded_positions(std::min(range_seconds(proxy) * rate, std::max(share, least)), proxy);
}

void RangeSender::send(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    const GivenRange sent = job.unsent.take_first(positions_at_once(proxy, job));
    tasks_.send_range(proxy, job, sent, context_.pace.position_ns(proxy, job), actions);
}

} // namespace cd
