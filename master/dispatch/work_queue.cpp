#include "master/dispatch/work_queue.hpp"

#include "common/core/check.hpp"
#include "master/dispatch/policy/matching_policy.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void WorkQueue::open(JobId job,
                     const ClusterOptions& options,
                     DispatchTree a,
                     DispatchTree b,
                     std::unique_ptr<MatchingPolicy> policy) {
    const bool is_new =
        jobs_.try_emplace(job, job, options, std::move(a), std::move(b), std::move(policy)).second;
    CD_CHECK(is_new);
}

void WorkQueue::close(JobId job) {
    unsent_ -= jobs_.at(job).waiting.size();
    unsent_ -= std::erase_if(suspects_, [&](const Suspect& suspect) { return suspect.job == job; });
    jobs_.erase(job);
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
    return std::ranges::any_of(jobs_, [&](const auto& job) { return job.second.uses(tree); });
}

bool WorkQueue::add(DispatchJob& job, std::uint64_t index, DispatchScenario scenario) {
    const auto [place, is_new] = job.scenarios.emplace(index, std::move(scenario));
    CD_CHECK(is_new);
    if (suspect(job, index, place->second)) {
        return true;
    }
    ++unsent_;
    job.waiting.push_back(index);
    return false;
}

void WorkQueue::put_back(DispatchJob& job, std::span<const std::uint64_t> scenarios) {
    for (const std::uint64_t index : scenarios) {
        job.at(index).where = Whereabouts::Waiting;
    }
    job.waiting.insert(job.waiting.begin(), scenarios.begin(), scenarios.end());
}

void WorkQueue::put_back_sent(DispatchJob& job, std::span<const std::uint64_t> scenarios) {
    unsent_ += scenarios.size();
    put_back(job, scenarios);
}

bool WorkQueue::suspect(const DispatchJob& job, std::uint64_t index, DispatchScenario& scenario) {
    if (!scenario.is_suspect()) {
        return false;
    }
    scenario.where = Whereabouts::Suspect;
    suspects_.push_back({job.id, index});
    ++unsent_;
    return true;
}

void WorkQueue::remove(DispatchJob& job, std::uint64_t index, const DispatchScenario& scenario) {
    if (scenario.where == Whereabouts::Waiting) {
        std::erase(job.waiting, index);
    } else {
        std::erase_if(suspects_, [&](const Suspect& suspect) {
            return suspect.job == job.id && suspect.scenario == index;
        });
    }
    --unsent_;
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
               return job.second.places.rest() == 0;
           });
}

} // namespace cd
