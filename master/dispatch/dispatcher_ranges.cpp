// Ranges of order positions, without analysis or matching. The first worker to run dry gets the
// next range, sized for a batch's duration at its measured rate, and smaller towards the end of a
// job.
#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "master/dispatch/dispatcher_state.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// One scenario in this many is measured for the blocks an average worker lacks.
constexpr std::uint64_t missing_period = 16;

} // namespace

// ---- Events -------------------------------------------------------------------------------------

Actions Dispatcher::places_given(JobId job_id, const PlaceRange& places, std::uint64_t after) {
    DispatchJob* job = state_->find_job(job_id);
    CD_CHECK(job != nullptr);
    CD_CHECK(places.count != 0);
    job->places.push_back(places);
    job->places_unsent += places.count;
    job->places_after = after;
    Actions actions;
    state_->give_places(actions);
    return actions;
}

std::vector<PlaceRange> Dispatcher::take_places(JobId job_id) {
    DispatchJob* job = state_->find_job(job_id);
    CD_CHECK(job != nullptr);
    std::vector<PlaceRange> taken(job->places.begin(), job->places.end());
    job->places.clear();
    job->places_unsent = 0;
    return taken;
}

Actions Dispatcher::places_answered(WorkerId worker,
                                    TaskId task,
                                    std::uint64_t count,
                                    double busy_seconds) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !proxy->tasks().contains(task)) {
        return {};
    }
    const ProxyTask& content = proxy->tasks().at(task);
    if (DispatchJob* job = state_->find_job(content.job)) {
        job->place_rate.add(static_cast<double>(count), busy_seconds);
        job->place_rates[worker].add(static_cast<double>(count), busy_seconds);
        job->missing_any.add(std::exchange(job->missing_in_ranges, 0), static_cast<double>(count));
    }
    proxy->note_busy(task, busy_seconds);
    proxy->note_progress(state_->now);
    proxy->answer_places(task, std::min(count, content.places_left));
    Actions actions;
    state_->refill(*proxy, actions);
    return actions;
}

void Dispatcher::roots_wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots) {
    WorkerProxy* proxy = state_->pool.find(worker);
    if (proxy == nullptr || !state_->is_tree_used(tree)) {
        return;
    }
    const WorkerPool::Missing missing = state_->pool.hold(*proxy, tree, roots);
    for (auto& [id, job] : state_->jobs) {
        if ((job.a.tree == tree || job.b.tree == tree) && proxy->tasks_of(id) != 0) {
            job.missing_in_ranges += state_->seconds_of(missing, *proxy);
        }
    }
}

std::uint64_t Dispatcher::places_unsent(JobId job) const {
    return state_->jobs.at(job).places_unsent;
}

std::uint64_t Dispatcher::places_enough(JobId job) const {
    state_->forget_place_totals();
    std::uint64_t enough = 0;
    for (const WorkerProxy* proxy : state_->pool.in_order()) {
        enough += proxy->takes_work() ? state_->places_at_once(*proxy, state_->jobs.at(job)) : 0;
    }
    return enough;
}

MissingCosts Dispatcher::missing_costs(JobId job_id) const {
    const DispatchJob& job = state_->jobs.at(job_id);
    MissingCosts costs;
    costs.all_fits = true;
    if (job.missing_matched.is_known() && job.missing_any.is_known()) {
        costs.matched = job.missing_matched.value();
        costs.any = job.missing_any.value();
    }
    const PooledTree& a = state_->pool.tree(job.a.tree);
    const PooledTree& b = state_->pool.tree(job.b.tree);
    const bool is_one = job.a.tree == job.b.tree;
    const std::uint64_t triangles = a.triangles_total + (is_one ? 0 : b.triangles_total);
    const std::uint64_t bytes = a.bytes_total + (is_one ? 0 : b.bytes_total);
    const std::uint64_t blocks = a.triangles.size() + (is_one ? 0 : b.triangles.size());
    for (const WorkerProxy* proxy : state_->pool.in_order()) {
        const double missing = state_->missing_share(*proxy, job);
        costs.all += missing * (static_cast<double>(bytes) / state_->link_of(*proxy) +
                                static_cast<double>(blocks) * limits::block_seconds);
        const std::uint64_t memory = proxy->facts().cache_bytes;
        costs.all_fits = costs.all_fits &&
                         (memory == 0 || triangles * limits::wide_bytes_per_triangle <= memory);
    }
    return costs;
}

// ---- Sending ------------------------------------------------------------------------------------

void Dispatcher::State::give_places(Actions& actions) {
    if (std::none_of(
            jobs.begin(), jobs.end(), [](const auto& job) { return !job.second.places.empty(); })) {
        return;
    }
    forget_place_totals();
    for (WorkerProxy* proxy : pool.in_order()) {
        give_places_to(*proxy, actions);
    }
}

void Dispatcher::State::forget_place_totals() const {
    for (const auto& [id, job] : jobs) {
        job.place_totals.reset();
    }
}

const PlaceTotals& Dispatcher::State::place_totals(const DispatchJob& job) const {
    if (job.place_totals) {
        return *job.place_totals;
    }
    PlaceTotals totals;
    totals.left = job.places_unsent + job.places_after;
    for (const WorkerProxy* proxy : pool.in_order()) {
        if (!proxy->takes_work()) {
            continue;
        }
        const double rate = places_per_second(*proxy, job);
        totals.rate += rate;
        if (proxy->is_claimed()) {
            continue;
        }
        totals.unclaimed += rate;
        totals.left += proxy->working();
        const double of_thread = rate / proxy->facts().threads;
        totals.quickest_but = std::max(totals.quickest_but, std::min(of_thread, totals.quickest));
        if (of_thread > totals.quickest) {
            totals.quickest = of_thread;
            totals.quickest_worker = proxy->id();
        }
    }
    return job.place_totals.emplace(totals);
}

void Dispatcher::State::give_places_to(WorkerProxy& proxy, Actions& actions) {
    while (DispatchJob* job = next_with_places(proxy)) {
        send_places(proxy, *job, actions);
    }
}

DispatchJob* Dispatcher::State::next_with_places(const WorkerProxy& proxy) {
    // Round robin over the jobs, as in `allocate_next`.
    const auto next = jobs.upper_bound(proxy.flushed_last());
    for (auto place = next; place != jobs.end(); ++place) {
        if (takes_places(proxy, place->second)) {
            return &place->second;
        }
    }
    for (auto place = jobs.begin(); place != next; ++place) {
        if (takes_places(proxy, place->second)) {
            return &place->second;
        }
    }
    return nullptr;
}

bool Dispatcher::State::takes_places(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (job.places.empty() || !proxy.takes_work() || proxy.is_claimed() || &proxy == reserved() ||
        proxy.tasks_of(job.id) >= limits::batches_at_worker) {
        return false;
    }
    // Sends the next range before the current one is finished.
    return proxy.working() < places_at_once(proxy, job) && !would_be_late(proxy, job);
}

bool Dispatcher::State::would_be_late(const WorkerProxy& proxy, const DispatchJob& job) const {
    const PlaceTotals& totals = place_totals(job);
    const bool is_quickest = totals.quickest_worker == proxy.id();
    const double quickest = is_quickest ? totals.quickest_but : totals.quickest;
    if (quickest <= 0) {
        return false;
    }
    // Compares one scenario on one thread with everything left on the other workers.
    const double rate = places_per_second(proxy, job);
    const double others = std::max(totals.unclaimed - rate, quickest);
    const auto left = static_cast<double>(totals.left - proxy.working());
    return proxy.facts().threads / rate >
           limits::copy_gain_min * std::max(left / others, 1 / quickest);
}

double Dispatcher::State::places_per_second(const WorkerProxy& proxy,
                                            const DispatchJob& job) const {
    const double otherwise =
        1e9 / mean_cost_ns.value_or(static_cast<double>(limits::scenario_ns_unknown));
    const auto own = job.place_rates.find(proxy.id());
    const double general_rate = job.place_rate.value_or(otherwise);
    const double rate =
        own == job.place_rates.end() ? general_rate : own->second.value_or(general_rate);
    return rate * proxy.facts().threads;
}

std::uint64_t Dispatcher::State::places_at_once(const WorkerProxy& proxy,
                                                const DispatchJob& job) const {
    const double rate = places_per_second(proxy, job);
    const double all = place_totals(job).rate;
    const double left = static_cast<double>(job.places_unsent + job.places_after);
    // Each worker gets two such shares; the rest is divided again.
    const double share = all > 0 ? left * rate / all / 2 : left;
    const double most = std::min(proxy.batch_seconds() * rate, share);
    return static_cast<std::uint64_t>(std::clamp(most,
                                                 static_cast<double>(proxy.facts().threads),
                                                 static_cast<double>(limits::range_scenarios_max)));
}

void Dispatcher::State::send_places(WorkerProxy& proxy, DispatchJob& job, Actions& actions) {
    PlaceRange& front = job.places.front();
    const PlaceRange sent{front.first, std::min(front.count, places_at_once(proxy, job))};
    front = {sent.end(), front.count - sent.count};
    if (front.count == 0) {
        job.places.pop_front();
    }
    job.places_unsent -= sent.count;
    served_last = job.id;

    const TaskId task{++task_last};
    ProxyTask content{job.id, {}, false, 0, now, false, 0, sent, sent.count};
    const double mean_ns = mean_cost_ns.value_or(static_cast<double>(limits::scenario_ns_unknown));
    content.cost_ns = sent.count * static_cast<std::uint64_t>(mean_ns);
    job.work_ns += content.cost_ns;
    proxy.start_task(task, std::move(content));
    actions.push_back(SendRange{proxy.id(), task, job.id, sent});
}

// ---- Missing blocks -----------------------------------------------------------------------------

double Dispatcher::State::missing_share(const WorkerProxy& proxy, const DispatchJob& job) const {
    const PooledTree& a = pool.tree(job.a.tree);
    const PooledTree& b = pool.tree(job.b.tree);
    const double held = a.held.roots_of(proxy.slot()) + b.held.roots_of(proxy.slot());
    return 1 - held / static_cast<double>(a.held.root_count() + b.held.root_count());
}

double Dispatcher::State::missing_with_any(const DispatchJob& job,
                                           const DispatchScenario& scenario) {
    const PooledTree& a = pool.tree(job.a.tree);
    const PooledTree& b = pool.tree(job.b.tree);
    held_triangles.assign(a.held.sum_count(), 0);
    a.held.add_held(scenario.roots.a, held_triangles);
    b.held.add_held(scenario.roots.b, held_triangles);
    double held = 0;
    double bytes_per_second = 0;
    for (const WorkerProxy* proxy : pool.in_order()) {
        held += static_cast<double>(held_triangles[proxy->slot()]);
        bytes_per_second += link_of(*proxy);
    }
    const auto workers = static_cast<double>(pool.in_order().size());
    double triangles = 0;
    double bytes = 0;
    for (const auto* side : {&a, &b}) {
        for (const WeightedRoot& root : side == &a ? scenario.roots.a : scenario.roots.b) {
            triangles += root.weight;
            bytes += 64.0 * side->bytes_64[root.root];
        }
    }
    const double blocks = static_cast<double>(scenario.roots.a.size() + scenario.roots.b.size());
    const double missing = std::max(0.0, 1 - held / (workers * std::max(triangles, 1.0)));
    return missing * (bytes * workers / bytes_per_second + blocks * limits::block_seconds);
}

void Dispatcher::State::measure_missing(DispatchJob& job, const DispatchScenario& scenario) {
    if (job.scenarios_held++ % missing_period == 0) {
        job.missing_any.add(missing_with_any(job, scenario), 1);
        job.missing_matched.add(job.missing_seconds, missing_period);
        job.missing_seconds = 0;
    }
}

} // namespace cd
