#include "tests/faults/simulation.hpp"

#include <algorithm>

namespace cd::tests {

using namespace std::chrono_literals;

Simulation::Simulation(std::uint64_t seed, bool logs) : world_(seed, logs) {
    world_.on_message = [this](const Route& route, const Message& message) {
        return observe(route, message);
    };
    world_.on_heard = [this](const Route& route, const Message& message) {
        world_.watcher.master_hears(route, message);
    };
    plan();
}

Simulation::~Simulation() {
    workers_.clear();
    clients_.clear();
    master_.reset();
}
// ---- Lives
// ----------------------------------------------------------------------------------------

void Simulation::start_worker() {
    WorkerHabits habits;
    habits.threads = static_cast<unsigned>(1 + world_.below(3));
    habits.cache_bytes = world_.happens(500) ? std::uint64_t{1} << 30 : 4000 + world_.below(60'000);
    habits.weight = world_.happens(300) ? 0.25 : 1;
    habits.serves_peers = world_.happens(800);
    const std::uint64_t id = ++host_last_;
    workers_.emplace(id, std::make_unique<WorkerProcess>(world_, id, habits));
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
    if (by_power) {
        world_.lose_power();
    }
    world_.in(world_.between(100ms, 4s), [this] { start_master(); });
}

void Simulation::start_master() {
    world_.log("master starts");
    ++outcome_.masters;
    master_ = std::make_unique<MasterProcess>(world_);
}

// ---- The run
// ----------------------------------------------------------------------------------------

void Simulation::check() {
    // Nothing but what runs on its host changes the master; what its threads and its journal have
    // done wakes the host, too.
    if (master_ == nullptr || master_->coordinator() == nullptr || !world_.has_run(master_host)) {
        return;
    }
    ++outcome_.checks;
    try {
        master_->coordinator()->check_invariants();
    } catch (const BrokenInvariant&) {
        // It has been noted.
    } catch (const std::exception& error) {
        world_.problem(std::string("an exception: ") + error.what());
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
        inspect();
    }
    outcome_.seconds = std::chrono::duration<double>(world_.now() - began).count();
    outcome_.problems = world_.problems();
    outcome_.scenarios_sent = world_.watcher.scenarios_sent();
    outcome_.results_repeated = world_.watcher.results_repeated();
    outcome_.recalled = world_.watcher.recalled();
    outcome_.called_off = world_.watcher.called_off();
    return outcome_;
}

Outcome simulate(std::uint64_t seed, bool logs, Mutation fault) {
    (void)known_jobs(); // Made outside of every simulation.
    mutation = fault;
    Outcome outcome;
    {
        Simulation simulation(seed, logs);
        outcome = simulation.run();
    }
    mutation = Mutation::None;
    return outcome;
}

} // namespace cd::tests
