#include "tests/faults/simulation.hpp"

#include "common/core/limits/worker.hpp"

#include <algorithm>
#include <utility>

namespace cd::tests {

using namespace std::chrono_literals;

Simulation::Simulation(std::uint64_t seed, const SimulationOptions& options)
    : world_(seed, options.logs) {
    world_.on_message = [this](const Route& route, const Message& message) {
        return observe(route, message);
    };
    world_.on_heard = [this](const Route& route, const Message& message) {
        if (const std::string wrong = world_.watcher.master_hears(route, message); !wrong.empty()) {
            world_.problem(wrong);
        }
        if (std::holds_alternative<Drain>(message)) {
            world_.troubles.add(Trouble::WorkerDrained);
        }
    };
    world_.watcher.quarantine = [this] {
        const Coordinator* coordinator = master_ == nullptr ? nullptr : master_->coordinator();
        return coordinator == nullptr ? std::set<std::uint64_t>{}
                                      : coordinator->alarms().quarantined();
    };
    plan(options.workers);
}

Simulation::~Simulation() {
    workers_.clear();
    clients_.clear();
    master_.reset();
}
// ---- Processes --------------------------------------------------------------------------------

void Simulation::start_worker() {
    WorkerHabits habits;
    habits.threads = static_cast<unsigned>(1 + world_.below(3));
    habits.cache_bytes = world_.happens(500) ? std::uint64_t{1} << 30 : 4000 + world_.below(60'000);
    habits.weight = world_.happens(300) ? 0.25 : 1;
    habits.serves_peers = world_.happens(800);
    habits.unkept.messages = world_.happens(300) ? 1 : limits::results_unkept_messages_max;
    const std::uint64_t id = ++host_last_;
    const auto& worker =
        workers_.emplace(id, std::make_unique<WorkerProcess>(world_, id, habits)).first->second;
    if (is_trouble_ && dangers_.liar != 0) {
        worker->host().slowness = 10 + static_cast<double>(world_.below(40));
        if (liars_ < Lies::liars_max && world_.happens(dangers_.liar)) {
            worker->host().liar = liars_++;
        }
    }
    ++outcome_.workers;
}

void Simulation::end_worker(std::uint64_t id, bool silently) {
    const auto worker = workers_.find(id);
    if (worker == workers_.end()) {
        return;
    }
    world_.log(worker->second->host().name + (silently ? " gone" : " killed"));
    *worker->second->host().is_silent = silently;
    workers_.erase(worker);
    world_.in(world_.between(100ms, 3s), [this] { start_worker(); });
}

void Simulation::end_master(bool by_power) {
    world_.log(by_power ? "power cut" : "master killed");
    *master_->host().is_silent = by_power && world_.happens(500);
    master_.reset();
    world_.power_cut_after = 0;
    world_.power_was_cut = false;
    world_.disk_is_unreadable = false;
    world_.troubles.add(by_power ? Trouble::PowerCut : Trouble::MasterKilled);
    if (by_power) {
        world_.lose_power();
    }
    if (world_.happens(dangers_.blocks_lost)) {
        lose_known_blocks(world_);
    }
    world_.in(world_.between(100ms, 4s), [this] { start_master(); });
}

void Simulation::start_master() {
    world_.log("master starts");
    ++outcome_.masters;
    master_ = std::make_unique<MasterProcess>(world_);
}

// ---- Run --------------------------------------------------------------------------------------

void Simulation::check() {
    // Only code on the master's host changes the master; its threads and its journal wake the host,
    // too.
    if (master_ == nullptr || master_->coordinator() == nullptr || !world_.has_run(master_host)) {
        return;
    }
    if (++runs_ % runs_between_checks_ != 0) {
        return;
    }
    ++outcome_.checks;
    // The check itself must not hit a simulated read error.
    const bool is_unreadable = std::exchange(world_.disk_is_unreadable, false);
    try {
        master_->coordinator()->check_invariants();
    } catch (const BrokenInvariant&) {
        // The problem is already recorded.
    } catch (const std::exception& error) {
        world_.problem(std::string("an exception: ") + error.what());
    }
    check_quarantine();
    check_caches();
    world_.disk_is_unreadable = is_unreadable;
}

void Simulation::check_caches() {
    if (master_ == nullptr || master_->coordinator() == nullptr) {
        return;
    }
    for (const auto& [id, worker] : workers_) {
        check_cache(*worker);
    }
}

/// Every worker the master names as source has the block, or has reported that it lacks it.
void Simulation::check_cache(WorkerProcess& worker) {
    const Session* session = worker.session();
    const std::uint64_t host = worker.host().id;
    const WorkerId id = world_.watcher.session_of(host);
    // A dying worker's messages reach nobody.
    if (session == nullptr || !session->is_connected() || id == WorkerId{} ||
        worker.host().is_dying) {
        return;
    }
    for (const BlockKey& block : master_->coordinator()->worker_desk().blocks_held_by(id)) {
        ++outcome_.blocks_checked;
        if (!session->cache().has({block.tree, block.root}) &&
            !world_.watcher.is_correction_under_way(host, block.tree, block.root)) {
            return world_.problem("the master believes that " + worker.host().name +
                                  " holds a block that is not there");
        }
    }
}

void Simulation::check_quarantine() {
    const Coordinator& coordinator = *master_->coordinator();
    if (coordinator.alarms().record().count != 0 && world_.watcher.lies.count() == 0) {
        world_.problem("an alarm, and nobody was wrong");
    }
    for (const std::uint64_t worker : coordinator.alarms().quarantined()) {
        if (!world_.watcher.lies.is_liar(worker)) {
            world_.problem("worker-" + std::to_string(worker) +
                           " is in quarantine, and was never wrong");
        }
        // The worker stays, but the alarm is raised.
        if (found_out_.insert(worker).second) {
            world_.in(world_.between(500ms, 5s), [this] { start_worker(); });
        }
    }
}

bool Simulation::is_done() const {
    return !is_trouble_ && clients_to_come_ == 0 && master_ != nullptr &&
           std::ranges::all_of(clients_,
                               [](const auto& client) { return client->end().has_value(); }) &&
           std::ranges::all_of(world_.watcher.jobs(),
                               [](const auto& job) { return !job.second.end.empty(); });
}

Outcome Simulation::run() {
    const Time began = world_.now();
    while (world_.problems().empty() && !is_done() && world_.step()) {
        ++outcome_.events;
        if (world_.power_was_cut) {
            end_master(true);
        }
        check();
    }
    if (world_.problems().empty()) {
        check_caches();
        inspect();
    }
    outcome_.seconds = std::chrono::duration<double>(world_.now() - began).count();
    outcome_.problems = world_.problems();
    outcome_.scenarios_sent = world_.watcher.scenarios_sent();
    outcome_.results_repeated = world_.watcher.results_repeated();
    outcome_.recalled = world_.watcher.recalled();
    outcome_.answering = world_.watcher.answering();
    outcome_.called_off = world_.watcher.called_off();
    outcome_.late_messages = world_.watcher.late_messages();
    outcome_.late_results = world_.watcher.late_results();
    outcome_.old_sessions = world_.watcher.old_sessions();
    outcome_.lies = world_.watcher.lies.count();
    outcome_.found_out = found_out_.size();
    outcome_.corrected = world_.watcher.corrected();
    outcome_.troubles = world_.troubles;
    return outcome_;
}

Outcome simulate(std::uint64_t seed, const SimulationOptions& options) {
    (void)known_jobs(); // Must be made outside of every simulation.
    if (options.workers != 0) {
        (void)large_job();
    }
    mutation = options.fault;
    Outcome outcome;
    {
        Simulation simulation(seed, options);
        outcome = simulation.run();
    }
    keep_known_blocks();
    mutation = Mutation::None;
    return outcome;
}

} // namespace cd::tests
