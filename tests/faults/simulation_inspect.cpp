// Checks a seed while it runs and at its end.
#include "master/journal/journal_records.hpp"
#include "tests/faults/simulation.hpp"

#include <algorithm>

namespace cd::tests {

// ---- Messages ---------------------------------------------------------------------------------

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
        world_.troubles.add(Trouble::WorkerPoisoned);
        world_.at(world_.now(), [this, id = route.from] { end_worker(id, false); });
    }
    if (!host.is_dying) {
        if (const std::string wrong = world_.watcher.worker_says(route, message); !wrong.empty()) {
            world_.problem(wrong);
        }
    }
    if (worker->second->keeps_too_much()) {
        world_.problem(host.name + " goes on with too many results that are not acknowledged");
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
    const auto deadly = deadly_.find(job->second.known->submit.name);
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
    const ClusterStatus status = master_->coordinator()->jobs().cluster();
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

// ---- At the end -------------------------------------------------------------------------------

/// Checks that every accepted job has ended, with exactly one result of each scenario.
void Simulation::inspect() {
    for (const auto& client : clients_) {
        inspect_job(*client);
    }
}

/// Returns the map, or the sums, of the scenarios that did not fail; empty if there is none.
ContactMap right_map(const KnownJob& job, const std::set<std::uint64_t>& failed) {
    ContactMapSum sum(job.parts);
    ScenarioResult result;
    result.level = job.submit.query.level;
    result.question = job.submit.query.question;
    for (result.index = 0; result.index < job.pairs.size(); ++result.index) {
        if (!failed.contains(result.index)) {
            const auto& pairs = job.pairs[result.index];
            result.pairs = pairs; // From level pairs on, sums count these.
            sum.add(result, job.submit.query.maps ? pairs : std::vector<ContactPair>());
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
    for (const auto& [scenario, result] : job.results) {
        if (!job.is_right(scenario) && !job.borne.contains(scenario)) {
            return world_.problem(name + ": a wrong result of scenario " +
                                  std::to_string(scenario));
        }
    }
    outcome_.failed += job.failed.size();
    outcome_.borne += job.borne.size();
    const bool has_map = decode_progress(job.progress).value().map_withdrawn.empty();
    if (has_map && job.map.map() != right_map(client.job(), job.failed)) {
        world_.problem(name + ": a wrong map of contacts");
    }
}

} // namespace cd::tests
