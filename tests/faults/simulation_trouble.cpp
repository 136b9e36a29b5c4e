// Plans the faults of a seed and causes them.
#include "tests/faults/simulation.hpp"

#include <algorithm>

namespace cd::tests {

using namespace std::chrono_literals;

namespace {

constexpr Duration tick_period = 100ms;
constexpr Duration trouble_min = 2s;
constexpr Duration trouble_max = 25s;
/// Time allowed after the last fault: more than the sum of all timeouts.
constexpr Duration patience = 300s;

} // namespace

// ---- The plan -----------------------------------------------------------------------------------

void Simulation::plan(std::size_t workers) {
    trouble_ends_ = world_.now() + world_.between(trouble_min, trouble_max);
    workers_wanted_ = 1 + world_.below(5);
    if (workers != 0) {
        workers_wanted_ = workers;
        runs_between_checks_ = 128; // A check takes longer with more workers.
    }
    // Each seed has its own kinds of fault: with all at once few workers get far.
    const auto maybe = [&](unsigned& danger, unsigned most) {
        danger = world_.happens(400) ? 1 + static_cast<unsigned>(world_.below(most)) : 0;
    };
    maybe(dangers_.worker_killed, 200);
    maybe(dangers_.worker_stopped, 150);
    maybe(dangers_.worker_cut_off, 150);
    maybe(dangers_.worker_drained, 150);
    maybe(dangers_.worker_slowed, 200);
    maybe(dangers_.master_killed, 250);
    maybe(dangers_.power_cut, 400);
    maybe(dangers_.worker_mute, 60);
    maybe(dangers_.worker_deaf, 60);
    maybe(dangers_.worker_apart, 300);
    maybe(dangers_.cache_shrunk, 300);
    maybe(dangers_.blocks_lost, 1000);
    maybe(dangers_.master_cut_off, 100);
    maybe(dangers_.master_stopped, 150);
    maybe(dangers_.disk_full, 200);
    maybe(dangers_.disk_unreadable, 200);
    maybe(dangers_.cancel, 60);
    if (world_.happens(500)) {
        plan_liars();
    }
    maybe(network_.lost, 20);
    network_.late = static_cast<unsigned>(world_.below(1000));
    maybe(network_.unwelcome, 600);
    maybe(network_.doubled, 60);
    maybe(network_.overtaken, 60);
    maybe(network_.delayed, 60);
    world_.network = network_;
    if (workers != 0) {
        ClusterOptions options = any_options();
        options.q = 1; // Spreads the work over all workers.
        options.strategy = "random";
        options.analysis = AnalysisMode::Always;
        plan_job(large_job(), options);
    }
    plan_jobs();
    start_master();
    for (std::size_t i = 0; i < workers_wanted_; ++i) {
        start_worker();
    }
    tick();
}

/// A liar is exposed if a scenario runs twice while its job runs: by a straggler, or by a lost
/// worker that returns. So workers are slow there.
void Simulation::plan_liars() {
    dangers_.liar = 500;
    dangers_.worker_cut_off += 50;
    trouble_ends_ = std::max(trouble_ends_, world_.now() + 20s);
}

void Simulation::plan_jobs() {
    const std::uint64_t jobs = 1 + world_.below(3);
    for (std::uint64_t i = 0; i < jobs; ++i) {
        const KnownJob& job = known_jobs()[world_.below(known_jobs().size())];
        plan_job(job, any_options());
    }
}

ClusterOptions Simulation::any_options() {
    ClusterOptions options;
    options.strategy = strategies[world_.below(strategies.size())].name;
    const auto depth_a = static_cast<std::uint32_t>(1 + world_.below(3));
    const auto depth_b = static_cast<std::uint32_t>(1 + world_.below(3));
    options.depths = {depth_a, depth_b};
    options.q = static_cast<std::uint32_t>(1 + world_.below(12));
    options.claim = world_.happens(200);
    options.seed = world_.below(100);
    options.analysis = static_cast<AnalysisMode>(world_.below(3));
    options.hints = options.seed % 4 != 0;
    if (options.seed % 8 == 1) {
        options.set_depth(1, std::nullopt);
    }
    return options;
}

void Simulation::plan_job(const KnownJob& job, ClusterOptions options) {
    if (world_.happens(250)) {
        deadly_[job.submit.name] = world_.below(job.submit.scenarios);
    }
    outcome_.scenarios += job.submit.scenarios;
    ++clients_to_come_;
    world_.in(world_.between(0s, 8s), [this, &job, options] {
        --clients_to_come_;
        clients_known_.insert(++host_last_);
        clients_.push_back(std::make_unique<ClientProcess>(world_, host_last_, job, options));
    });
}

// ---- Faults -----------------------------------------------------------------------------------

void Simulation::tick() {
    world_.wake_all();
    if (is_trouble_) {
        cause_trouble();
    }
    for (auto worker = workers_.begin(); worker != workers_.end();) {
        const std::uint64_t id = (worker++)->first;
        if (workers_.at(id)->has_ended()) {
            end_worker(id, false);
        }
    }
    world_.in(tick_period, [this] { tick(); });
}

void Simulation::cause_trouble() {
    if (world_.now() >= trouble_ends_) {
        return stop_trouble();
    }
    // Chances are per second; a tick is a tenth of a second.
    const auto strikes = [&](unsigned danger) { return world_.below(10'000) < danger; };
    for (auto worker = workers_.begin(); worker != workers_.end();) {
        cause_worker_trouble(*(worker++)->second);
    }
    if (strikes(dangers_.disk_full) && !world_.disk_is_full) {
        world_.log("disk full");
        world_.disk_is_full = true;
        world_.in(world_.between(500ms, 6s), [this] { world_.disk_is_full = false; });
    }
    if (strikes(dangers_.cancel) && !clients_.empty()) {
        clients_[world_.below(clients_.size())]->cancel();
    }
    if (master_ == nullptr) {
        return;
    }
    if (strikes(dangers_.disk_unreadable) && !world_.disk_is_unreadable) {
        world_.log("disk unreadable");
        world_.disk_is_unreadable = true;
        world_.in(world_.between(100ms, 5s), [this] { world_.disk_is_unreadable = false; });
    }
    if (strikes(dangers_.master_stopped)) {
        world_.log("master stopped");
        master_->host().stopped_until = world_.now() + world_.between(100ms, 18s);
    }
    if (strikes(dangers_.master_cut_off)) {
        world_.log("master cut off");
        master_->host().cut_off_until = world_.now() + world_.between(100ms, 18s);
    }
    if (strikes(dangers_.power_cut) && world_.power_cut_after == 0) {
        world_.power_cut_after = 1 + world_.below(12);
    }
    if (strikes(dangers_.master_killed)) {
        end_master(false);
    }
}

void Simulation::cause_worker_trouble(WorkerProcess& worker) {
    const auto strikes = [&](unsigned danger) { return world_.below(10'000) < danger; };
    Host& host = worker.host();
    if (strikes(dangers_.worker_stopped)) {
        world_.log(host.name + " stopped");
        host.stopped_until = world_.now() + world_.between(100ms, 20s);
    }
    if (strikes(dangers_.worker_cut_off)) {
        world_.log(host.name + " cut off");
        host.cut_off_until = world_.now() + world_.between(100ms, 20s);
    }
    cut_ways(host);
    if (strikes(dangers_.cache_shrunk) && worker.session() != nullptr && !world_.is_stopped(host)) {
        Session& session = *worker.session();
        if (session.let_go(world_.below(session.cache().bytes() + 1)) != 0) {
            world_.log(host.name + " lets go of blocks");
            world_.troubles.add(Trouble::CacheShrunk);
        }
        world_.wake(host);
    }
    if (strikes(dangers_.worker_slowed)) {
        host.slowness = 1 + static_cast<double>(world_.below(20));
        host.slowed_at = world_.now();
    }
    if (strikes(dangers_.worker_drained) && !world_.is_stopped(host)) {
        world_.log(host.name + " drained");
        worker.drain();
    }
    if (strikes(dangers_.worker_killed)) {
        const bool silently = world_.happens(400);
        world_.troubles.add(silently ? Trouble::WorkerGone : Trouble::WorkerKilled);
        end_worker(host.id, silently);
    }
}

/// Cuts one direction to the master, or all connections to other workers.
void Simulation::cut_ways(Host& host) {
    const auto cut = [&](unsigned danger, const char* what, Time& until) {
        if (world_.below(10'000) < danger) {
            world_.log(host.name + what);
            until = world_.now() + world_.between(100ms, 20s);
        }
    };
    cut(dangers_.worker_mute, " mute", host.mute_until);
    cut(dangers_.worker_deaf, " deaf", host.deaf_until);
    cut(dangers_.worker_apart, " apart", host.apart_until);
}

void Simulation::stop_trouble() {
    world_.log("no more trouble");
    check_caches();
    is_trouble_ = false;
    world_.network = {};
    world_.disk_is_full = false;
    world_.disk_is_unreadable = false;
    world_.power_cut_after = 0;
    for (const auto& [id, worker] : workers_) {
        worker->host().stopped_until = {};
        worker->host().cut_off_until = {};
        worker->host().mute_until = {};
        worker->host().deaf_until = {};
        worker->host().apart_until = {};
        worker->host().slowness = 1;
        worker->host().slowed_at = {};
    }
    if (master_ != nullptr) {
        master_->host().stopped_until = {};
        master_->host().cut_off_until = {};
    }
    world_.in(patience, [this] {
        if (!is_done()) {
            world_.problem("no progress: jobs have not ended long after the last fault" +
                           what_stands_still());
        }
    });
}

} // namespace cd::tests
