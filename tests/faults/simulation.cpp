#include "tests/faults/simulation.hpp"

#include "common/core/limits.hpp"
#include "master/journal_records.hpp"

#include <algorithm>

namespace cd::tests {

using namespace std::chrono_literals;

namespace {

constexpr Duration tick_period = 100ms;
constexpr Duration trouble_min = 2s;
constexpr Duration trouble_max = 25s;
/// After the last fault: more than all timeouts on the way.
constexpr Duration patience = 300s;
constexpr std::uint64_t invariants_period = 4;

} // namespace

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

// ---- The plan -----------------------------------------------------------------------------------

void Simulation::plan() {
    trouble_ends_ = world_.now() + world_.between(trouble_min, trouble_max);
    workers_wanted_ = 1 + world_.below(5);
    // Each seed has its own kinds of trouble: with all of them at once few get far.
    const auto maybe = [&](unsigned& danger, unsigned most) {
        danger = world_.happens(400) ? 1 + static_cast<unsigned>(world_.below(most)) : 0;
    };
    maybe(dangers_.worker_killed, 200);
    maybe(dangers_.worker_stopped, 150);
    maybe(dangers_.worker_cut_off, 150);
    maybe(dangers_.worker_drained, 150);
    maybe(dangers_.worker_slowed, 200);
    maybe(dangers_.master_killed, 250);
    maybe(dangers_.power_cut, 250);
    maybe(dangers_.master_stopped, 150);
    maybe(dangers_.disk_full, 200);
    maybe(dangers_.cancel, 60);
    maybe(network_.lost, 20);
    maybe(network_.doubled, 60);
    maybe(network_.overtaken, 60);
    maybe(network_.delayed, 60);
    world_.network = network_;
    plan_jobs();
    start_master();
    for (std::size_t i = 0; i < workers_wanted_; ++i) {
        start_worker();
    }
    tick();
}

void Simulation::plan_jobs() {
    clients_to_come_ = 1 + world_.below(3);
    for (std::size_t i = 0; i < clients_to_come_; ++i) {
        const KnownJob& job = known_jobs()[world_.below(known_jobs().size())];
        ClusterOptions options;
        options.strategy = static_cast<Strategy>(world_.below(6));
        options.depth_a = static_cast<std::uint32_t>(1 + world_.below(3));
        options.depth_b = static_cast<std::uint32_t>(1 + world_.below(3));
        options.q = static_cast<std::uint32_t>(1 + world_.below(12));
        options.claim = world_.happens(200);
        options.seed = world_.below(100);
        options.analysis = static_cast<AnalysisMode>(world_.below(3));
        options.hints = options.seed % 4 != 0;
        if (options.seed % 8 == 1) {
            options.depth_b.reset();
        }
        if (world_.happens(250)) {
            deadly_[job.submit.name] = world_.below(job.submit.scenarios);
        }
        outcome_.scenarios += job.submit.scenarios;
        world_.in(world_.between(0s, 8s), [this, &job, options] {
            --clients_to_come_;
            clients_known_.insert(++host_last_);
            clients_.push_back(std::make_unique<ClientProcess>(world_, host_last_, job, options));
        });
    }
}

// ---- Trouble
// --------------------------------------------------------------------------------------

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
    // A tick is a tenth of a second.
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
    if (strikes(dangers_.master_stopped)) {
        world_.log("master stopped");
        master_->host().stopped_until = world_.now() + world_.between(100ms, 18s);
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
    if (strikes(dangers_.worker_slowed)) {
        host.slowness = 1 + static_cast<double>(world_.below(20));
    }
    if (strikes(dangers_.worker_drained) && !world_.is_stopped(host)) {
        world_.log(host.name + " drained");
        worker.drain();
    }
    if (strikes(dangers_.worker_killed)) {
        end_worker(host.id, world_.happens(400));
    }
}

void Simulation::stop_trouble() {
    world_.log("no more trouble");
    is_trouble_ = false;
    world_.network = {};
    world_.disk_is_full = false;
    world_.power_cut_after = 0;
    for (const auto& [id, worker] : workers_) {
        worker->host().stopped_until = {};
        worker->host().cut_off_until = {};
        worker->host().slowness = 1;
    }
    if (master_ != nullptr) {
        master_->host().stopped_until = {};
    }
    world_.in(patience, [this] {
        if (!is_done()) {
            world_.problem("no progress: jobs have not ended long after the last fault" +
                           what_stands_still());
        }
    });
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

// ---- What is looked at
// ----------------------------------------------------------------------------

bool Simulation::observe(const Route& route, const Message& message) {
    if (route.from == master_host) {
        const std::string wrong = clients_known_.contains(route.to)
                                      ? check_client_hears(message)
                                      : world_.watcher.master_says(route, message);
        if (!wrong.empty()) {
            world_.problem(wrong);
        }
        return true;
    }
    const auto worker = workers_.find(route.from);
    if (route.to != master_host || worker == workers_.end()) {
        return true;
    }
    Host& host = worker->second->host();
    if (!host.is_dying && is_deadly(message)) {
        host.is_dying = true;
        world_.at(world_.now(), [this, id = route.from] { end_worker(id, false); });
    }
    if (!host.is_dying) {
        if (const std::string wrong = world_.watcher.worker_says(route, message); !wrong.empty()) {
            world_.problem(wrong);
        }
    }
    return !host.is_dying;
}

bool Simulation::is_deadly(const Message& message) const {
    const auto* results = std::get_if<Results>(&message);
    if (results == nullptr || deadly_.empty()) {
        return false;
    }
    const auto job = world_.watcher.jobs().find(results->job);
    if (job == world_.watcher.jobs().end()) {
        return false;
    }
    const auto deadly = deadly_.find(decode_job(job->second.record).value().submit.name);
    if (deadly == deadly_.end()) {
        return false;
    }
    const std::vector<std::uint64_t> scenarios = scenarios_in(*results);
    return std::ranges::find(scenarios, deadly->second) != scenarios.end();
}

std::string Simulation::check_client_hears(const Message& message) const {
    const std::map<JobId, DurableJob>& jobs = world_.watcher.jobs();
    if (const auto* accepted = std::get_if<Accepted>(&message)) {
        return jobs.contains(accepted->job) ? "" : "a job is accepted that is not on the disk";
    }
    const auto* status = std::get_if<JobStatus>(&message);
    if (status == nullptr || status->state == JobState::Running) {
        return "";
    }
    const auto job = jobs.find(status->job);
    return job == jobs.end() || job->second.end.empty()
               ? "a client hears of an end that is not on the disk"
               : "";
}

std::string Simulation::what_stands_still() {
    if (master_ == nullptr || master_->coordinator() == nullptr) {
        return "; there is no master";
    }
    const ClusterStatus status = master_->coordinator()->cluster_status();
    std::string text;
    for (const WorkerStatus& worker : status.workers) {
        text += "; " + worker.name + ": " + std::to_string(worker.tasks) + " tasks with " +
                std::to_string(worker.working) + ", " + std::to_string(worker.buffered) +
                " buffered";
    }
    for (const JobStatus& job : status.jobs) {
        if (job.state == JobState::Running) {
            text += "; job " + std::to_string(job.job.value) + ": " +
                    std::to_string(job.summary.merged()) + " of " +
                    std::to_string(job.summary.total) +
                    (job.paused.empty() ? "" : ", paused: " + job.paused);
        }
    }
    return text;
}

void Simulation::check() {
    if (master_ == nullptr || master_->coordinator() == nullptr ||
        outcome_.events % invariants_period != 0) {
        return;
    }
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

/// Every job that was accepted has ended, with exactly one result of each scenario.
void Simulation::inspect() {
    for (const auto& client : clients_) {
        inspect_job(*client);
    }
}

/// Of the scenarios that were answered; nothing where no map was asked for.
ContactMap right_map(const KnownJob& job, const std::set<std::uint64_t>& failed) {
    ContactMapSum sum;
    for (std::uint64_t scenario = 0; scenario < job.pairs.size(); ++scenario) {
        if (!failed.contains(scenario)) {
            sum.add(job.pairs[scenario]);
        }
    }
    return sum.take();
}

void Simulation::inspect_job(const ClientProcess& client) {
    const DurableJob& job = world_.watcher.jobs().at(*client.id());
    const std::string name = "job " + std::to_string(client.id()->value);
    const JobStatus& end = *client.end();
    outcome_.copies += end.copies;
    if (end.state == JobState::Cancelled) {
        ++outcome_.cancelled;
        return;
    }
    if (end.state != JobState::Done) {
        return world_.problem(name + " failed: " + end.failure);
    }
    if (job.results.size() != client.job().digests.size()) {
        return world_.problem(name + " has not one result for each scenario");
    }
    for (const auto& [scenario, digest] : job.results) {
        const bool has_failed = job.failed.contains(scenario);
        const bool is_right = has_failed ? digest == digest_of_lost(client.job(), scenario)
                                         : digest == client.job().digests[scenario];
        if (!is_right) {
            return world_.problem(name + ": a wrong result of scenario " +
                                  std::to_string(scenario));
        }
        outcome_.failed += has_failed ? 1 : 0;
    }
    if (job.map.map() != right_map(client.job(), job.failed)) {
        world_.problem(name + ": a wrong map of contacts");
    }
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
