#include "master/dispatch/work_queue.hpp"

#include "common/core/check.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/policy/matching_policy.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void WorkQueue::open(JobId job,
                     const ClusterOptions& options,
                     DispatchTrees trees,
                     std::unique_ptr<MatchingPolicy> policy,
                     JobRank rank) {
    const bool is_new =
        jobs_.try_emplace(job, job, options, std::move(trees), std::move(policy)).second;
    CD_CHECK(is_new);
    analysis_order_.open(job, rank);
    order_.open(job, std::move(rank));
}

void WorkQueue::set_priority(JobId job, std::int32_t priority) {
    order_.set_priority(job, priority);
    analysis_order_.set_priority(job, priority);
}

void WorkQueue::close(JobId job) {
    unsent_ -= jobs_.at(job).waiting.size();
    unsent_ -= std::erase_if(suspects_, [&](const Suspect& suspect) { return suspect.job == job; });
    jobs_.erase(job);
    order_.close(job);
    analysis_order_.close(job);
}

std::vector<DispatchJob*> WorkQueue::in_order() {
    std::vector<DispatchJob*> jobs;
    jobs.reserve(jobs_.size());
    for (auto& [id, job] : jobs_) {
        jobs.push_back(&job);
    }
    std::ranges::sort(jobs, [this](const DispatchJob* one, const DispatchJob* other) {
        return order_.comes_before(one->id, other->id);
    });
    return jobs;
}

DispatchJob* WorkQueue::find(JobId job) {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

const DispatchJob* WorkQueue::find(JobId job) const {
    const auto found = jobs_.find(job);
    return found == jobs_.end() ? nullptr : &found->second;
}

bool WorkQueue::is_tree_used(TreeId tree) const {
    return std::ranges::any_of(jobs_, [&](const auto& job) { return job.second.trees.have(tree); });
}

bool WorkQueue::add(DispatchJob& job, std::uint64_t position, DispatchScenario scenario) {
    const auto [added, is_new] = job.scenarios.emplace(position, std::move(scenario));
    CD_CHECK(is_new);
    if (suspect(job, position, added->second)) {
        return true;
    }
    add_unsent(job, 1);
    job.waiting.push_back(position);
    return false;
}

void WorkQueue::put_back(DispatchJob& job, std::span<const std::uint64_t> positions) {
    for (const std::uint64_t position : positions) {
        job.at(position).where = Whereabouts::Waiting;
    }
    job.waiting.insert(job.waiting.begin(), positions.begin(), positions.end());
}

void WorkQueue::put_back_sent(DispatchJob& job, std::span<const std::uint64_t> positions) {
    add_unsent(job, positions.size());
    put_back(job, positions);
}

bool WorkQueue::suspect(DispatchJob& job, std::uint64_t position, DispatchScenario& scenario) {
    if (!scenario.is_suspect()) {
        return false;
    }
    scenario.where = Whereabouts::Suspect;
    suspects_.push_back({job.id, position});
    add_unsent(job, 1);
    return true;
}

void WorkQueue::remove(DispatchJob& job, std::uint64_t position, const DispatchScenario& scenario) {
    if (scenario.where == Whereabouts::Waiting) {
        std::erase(job.waiting, position);
    } else if (scenario.where == Whereabouts::Suspect) {
        std::erase_if(suspects_, [&](const Suspect& suspect) {
            return suspect.job == job.id && suspect.position == position;
        });
    }
    leave(job, mutated(Mutation::RoomNotGivenBack) ? 0 : 1);
}

Suspect WorkQueue::take_suspect() {
    const Suspect first = suspects_.front();
    suspects_.pop_front();
    return first;
}

bool WorkQueue::set_paused(bool is_paused) {
    return std::exchange(is_paused_, is_paused);
}

bool WorkQueue::something_waits() const {
    return !suspects_.empty() ||
           std::ranges::any_of(jobs_, [](const auto& job) { return !job.second.waiting.empty(); });
}

bool WorkQueue::is_exhausted() const {
    return unsent_ == 0 && is_paused_ && std::ranges::all_of(jobs_, [](const auto& job) {
               return job.second.unsent.rest() == 0;
           });
}

} // namespace cd
