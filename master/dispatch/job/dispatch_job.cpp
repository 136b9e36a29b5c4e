#include "master/dispatch/job/dispatch_job.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/policy/matching_policy.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

/// Number of losses after which a scenario is given up.
std::uint32_t losses_max() {
    return mutated(Mutation::PoisonToleratedTooLong)  ? ~0u
           : mutated(Mutation::PoisonGivenUpTooEarly) ? limits::scenario_losses_max - 1
                                                      : limits::scenario_losses_max;
}

template <class Scenarios>
auto& unanswered_one(Scenarios& scenarios, std::uint64_t index) {
    const auto found = scenarios.find(index);
    const bool scenario_in_hand_is_unanswered = found != scenarios.end();
    CD_CHECK(scenario_in_hand_is_unanswered);
    return found->second;
}

std::vector<WeightedRoot> with_triangles(const DispatchTree& tree,
                                         std::span<const RootIndex> roots) {
    std::vector<WeightedRoot> with;
    with.reserve(roots.size());
    for (const RootIndex root : roots) {
        with.push_back({root, tree.root_triangles.at(root)});
    }
    return with;
}

} // namespace

bool DispatchScenario::is_lost_for_good() const {
    return losses.count() >= losses_max();
}

bool DispatchScenario::is_suspect() const {
    return losses.count() + 1 == limits::scenario_losses_max;
}

bool DispatchScenario::leave_task(TaskId one) {
    if (!copy) {
        return false;
    }
    if (copy->task != one) {
        worker = copy->worker;
        task = copy->task;
    }
    copy.reset();
    return true;
}

void UnsentPlaces::add(const PlaceRange& places, std::uint64_t after) {
    CD_CHECK(places.count != 0);
    ranges_.push_back(places);
    count_ += places.count;
    after_ = after;
}

PlaceRange UnsentPlaces::take_first(std::uint64_t most) {
    PlaceRange& front = ranges_.front();
    const PlaceRange taken{front.first, std::min(front.count, most)};
    front = {taken.end(), front.count - taken.count};
    if (front.count == 0) {
        ranges_.pop_front();
    }
    count_ -= taken.count;
    return taken;
}

std::vector<PlaceRange> UnsentPlaces::take_all() {
    std::vector<PlaceRange> taken = all();
    ranges_.clear();
    count_ = 0;
    return taken;
}

DispatchJob::DispatchJob(JobId job,
                         const ClusterOptions& job_options,
                         DispatchTree tree_a,
                         DispatchTree tree_b,
                         std::unique_ptr<MatchingPolicy> matching)
    : id(job),
      options(job_options),
      a(std::move(tree_a)),
      b(std::move(tree_b)),
      policy(std::move(matching)) {}
DispatchJob::~DispatchJob() = default;

DispatchScenario& DispatchJob::at(std::uint64_t index) {
    return unanswered_one(scenarios, index);
}

const DispatchScenario& DispatchJob::at(std::uint64_t index) const {
    return unanswered_one(scenarios, index);
}

DispatchScenario DispatchJob::scenario_of(const AnalysedScenario& analysed) const {
    DispatchScenario scenario;
    scenario.roots = {with_triangles(a, analysed.roots_a), with_triangles(b, analysed.roots_b)};
    scenario.weight = {analysed.bytes,
                       analysed.predicted_ns != 0 ? analysed.predicted_ns
                                                  : limits::scenario_ns_unknown};
    scenario.losses = analysed.losses;
    return scenario;
}

} // namespace cd
