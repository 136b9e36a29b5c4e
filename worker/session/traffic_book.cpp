#include "worker/session/traffic_book.hpp"

#include <utility>

namespace cd {

void TrafficBook::job_added(JobId job, std::set<TreeId> trees) {
    jobs_.try_emplace(job, Job{std::move(trees), {}});
}

void TrafficBook::job_removed(JobId job) {
    jobs_.erase(job);
    std::erase_if(asked_by_, [&](const auto& entry) { return entry.second == job; });
}

void TrafficBook::tree_removed(TreeId tree) {
    std::erase_if(asked_by_, [&](const auto& entry) { return entry.first.tree == tree; });
    std::erase_if(jobs_, [&](const auto& job) { return job.second.trees.contains(tree); });
}

void TrafficBook::add(JobId job, const BlockTraffic& traffic) {
    total_ += traffic;
    if (const auto found = jobs_.find(job); found != jobs_.end()) {
        found->second.traffic += traffic;
    }
}

JobId TrafficBook::who_asked(const SubtreeKey& key) const {
    const auto found = asked_by_.find(key);
    return found == asked_by_.end() ? JobId{} : found->second;
}

void TrafficBook::found(JobId job, std::uint64_t subtrees) {
    BlockTraffic traffic;
    traffic.hits = subtrees;
    add(job, traffic);
}

void TrafficBook::missed(JobId job, const SubtreeKey& key) {
    BlockTraffic traffic;
    traffic.misses = 1;
    add(job, traffic);
    asked_by_[key] = job;
}

void TrafficBook::hinted(JobId job, const SubtreeKey& key) {
    BlockTraffic traffic;
    traffic.hinted = 1;
    add(job, traffic);
    asked_by_[key] = job;
}

void TrafficBook::evicted(TreeId tree) {
    ++total_.evictions;
    for (auto& [id, job] : jobs_) {
        job.traffic.evictions += job.trees.contains(tree) ? 1 : 0;
    }
}

void TrafficBook::came_from_master(const SubtreeKey& key, std::uint64_t bytes) {
    BlockTraffic traffic;
    traffic.master_bytes = bytes;
    add(who_asked(key), traffic);
}

void TrafficBook::came_from_peer(const SubtreeKey& key, std::uint64_t bytes) {
    BlockTraffic traffic;
    traffic.peer_bytes = bytes;
    add(who_asked(key), traffic);
}

BlockTraffic TrafficBook::take(JobId job) {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? BlockTraffic{} : std::exchange(found->second.traffic, {});
}

} // namespace cd
