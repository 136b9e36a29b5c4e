// Checks the handling of workers that now and then give wrong results. Two differing results of a
// scenario expose one of the workers; from then on nothing it sent counts, in any master
// incarnation.
#include "master/journal/journal_records.hpp"
#include "tests/faults/watcher.hpp"

namespace cd::tests {

namespace {

std::string name_of(std::uint64_t worker) {
    return "worker-" + std::to_string(worker);
}

bool is_work(const Message& message) {
    return std::holds_alternative<WorkUnit>(message) || std::holds_alternative<Hint>(message) ||
           std::holds_alternative<Recall>(message) || std::holds_alternative<AddJob>(message) ||
           std::holds_alternative<AddTree>(message) || std::holds_alternative<Subtrees>(message) ||
           std::holds_alternative<FetchFromPeers>(message);
}

} // namespace

bool DurableJob::is_right(std::uint64_t scenario) const {
    return results.at(scenario).digest == (failed.contains(scenario)
                                               ? digest_of_lost(*known, scenario)
                                               : known->digests[scenario]);
}

std::string Watcher::check_quarantined(const Route& route, const Message& message) const {
    return is_work(message) && quarantine().contains(route.to)
               ? name_of(route.to) + " is in quarantine, and gets something"
               : "";
}

/// Notes that the master accepted the worker's answer: the first one, or one it compared.
void Watcher::acknowledged(std::uint64_t worker, JobId id, std::uint64_t scenario) {
    const auto job = jobs_.find(id);
    if (job == jobs_.end() || !job->second.end.empty() || job->second.failed.contains(scenario) ||
        quarantine().contains(worker)) {
        return; // Nothing is compared any more, or nothing of this worker.
    }
    const auto result = job->second.results.find(scenario);
    if (result == job->second.results.end()) {
        return; // Withdrawn since.
    }
    if (!lies.is_told(worker, id, scenario)) {
        result->second.is_witnessed = true;
    } else if (job->second.is_right(scenario)) {
        refuted_.insert({id, worker});
    }
}

void Watcher::ends(JobId job) {
    quarantined_at_end_[job] = quarantine();
}

/// The only function that decides which wrong results are excusable: results of a worker that was
/// never exposed, for scenarios that no other worker answered.
bool Watcher::may_be_wrong(const DurableResult& result,
                           std::uint64_t author,
                           const std::set<std::uint64_t>& quarantined) const {
    return author != 0 && !result.is_witnessed && !quarantined.contains(author);
}

std::string Watcher::check_end(JobId id, DurableJob& job) const {
    if (decode_end(job.end).value().state != JobState::Done) {
        return {};
    }
    const std::string name = "job " + std::to_string(id.value);
    const std::set<std::uint64_t>& quarantined = quarantined_at_end_.at(id);
    for (const auto& [in_job, worker] : refuted_) {
        if (in_job == id && !quarantined.contains(worker)) {
            return name + " ends, and " + name_of(worker) +
                   ", which was found wrong, is not in quarantine";
        }
    }
    for (const auto& [scenario, result] : job.results) {
        if (job.is_right(scenario)) {
            continue;
        }
        const std::uint64_t author = lies.author_of(id, scenario);
        if (!may_be_wrong(result, author, quarantined)) {
            return name + ": a wrong result of scenario " + std::to_string(scenario) +
                   (author == 0 ? "" : " stays, of " + name_of(author));
        }
        job.borne.insert(scenario);
    }
    return {};
}

} // namespace cd::tests
