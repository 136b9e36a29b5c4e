#include "worker/session/carry_over.hpp"

namespace cd {

namespace {

std::uint64_t size_of(const Results& results) {
    return results.records.size() + results.map.size();
}

} // namespace

void UnkeptResults::add(Results& results) {
    results.sequence = ++last_;
    bytes_ += size_of(results);
    messages_.emplace(results.sequence, results);
}

void UnkeptResults::kept(std::span<const std::uint64_t> sequences) {
    for (const std::uint64_t sequence : sequences) {
        const auto found = messages_.find(sequence);
        if (found != messages_.end()) {
            bytes_ -= size_of(found->second);
            messages_.erase(found);
        }
    }
}

void UnkeptResults::clear() {
    messages_.clear();
    bytes_ = 0;
}

std::vector<Results> UnkeptResults::again() {
    std::vector<Results> again;
    for (auto& [sequence, message] : messages_) {
        message.task = TaskId{};
        again.push_back(message);
    }
    return again;
}

bool UnkeptResults::has_room() const {
    return bytes_ < bounds_.bytes && messages_.size() < bounds_.messages;
}

std::map<JobId, UnkeptOfJob> UnkeptResults::by_job() const {
    std::map<JobId, UnkeptOfJob> jobs;
    for (const auto& [sequence, message] : messages_) {
        UnkeptOfJob& job = jobs[message.job];
        job.scenarios += message.count;
        job.compute_seconds += message.compute_seconds;
    }
    return jobs;
}

void CarryOver::enter(const Sha256& its_cluster) {
    if (cluster != its_cluster) {
        results.clear();
        cache.drop_parked();
    }
    cluster = its_cluster;
}

} // namespace cd
