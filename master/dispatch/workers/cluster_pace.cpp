#include "master/dispatch/workers/cluster_pace.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>

namespace cd {

void ClusterPace::time_is(double seconds) {
    CD_CHECK(seconds >= now_);
    now_ = seconds;
}

void ClusterPace::add_work(WorkerProxy& proxy, std::uint64_t predicted_ns, double seconds) {
    const double predicted = 1e-9 * static_cast<double>(predicted_ns);
    proxy.pace.work.add(predicted, seconds);
    general_.work.add(predicted, seconds);
}

void ClusterPace::add_transfer(WorkerProxy& proxy, std::uint64_t bytes, double seconds) {
    proxy.pace.bytes.add(static_cast<double>(bytes), seconds);
    general_.bytes.add(static_cast<double>(bytes), seconds);
}

void ClusterPace::add_scenario(std::uint64_t cost_ns) {
    mean_cost_ns_.add(static_cast<double>(cost_ns), 1);
}

double ClusterPace::mean_cost_ns() const {
    return mean_cost_ns_.value_or(static_cast<double>(limits::scenario_ns_unknown));
}

std::uint64_t ClusterPace::mean_cost_of(std::uint64_t positions) const {
    return positions * std::max<std::uint64_t>(1, static_cast<std::uint64_t>(mean_cost_ns()));
}

double ClusterPace::positions_per_second(const WorkerProxy& proxy, const DispatchJob& job) const {
    return job.range_pace.per_thread(proxy.id(), 1e9 / mean_cost_ns()) * proxy.facts().threads;
}

std::uint64_t ClusterPace::position_ns(const WorkerProxy& proxy, const DispatchJob& job) const {
    const double each = 1e9 * power_of(proxy) / positions_per_second(proxy, job);
    return static_cast<std::uint64_t>(std::clamp(each, 1.0, 1e12));
}

double ClusterPace::thread_seconds_of(const TaskInFlight& task,
                                      const WorkerProxy& proxy,
                                      const DispatchJob& job) const {
    return task.is_analysed ? 1e-9 * static_cast<double>(task.cost_ns) / speed_of(proxy)
                            : static_cast<double>(task.left()) * proxy.facts().threads /
                                  positions_per_second(proxy, job);
}

double ClusterPace::seconds_of(const BlockPlan::Missing& missing, const WorkerProxy& proxy) const {
    return static_cast<double>(missing.bytes) / link_of(proxy) +
           static_cast<double>(missing.roots.size()) * timing::block_seconds;
}

} // namespace cd
