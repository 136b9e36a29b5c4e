#include "master/dispatch/job/dispatch_job.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "master/base/mutation.hpp"
#include "master/dispatch/policy/matching_policy.hpp"

#include <algorithm>
#include <ranges>
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
auto& unanswered_one(Scenarios& scenarios, std::uint64_t position) {
    const auto found = scenarios.find(position);
    const bool scenario_in_hand_is_unanswered = found != scenarios.end();
    CD_CHECK(scenario_in_hand_is_unanswered);
    return found->second;
}

TreeRoots with_triangles(const DispatchTree& tree, std::span<const RootIndex> roots) {
    TreeRoots with{tree.tree, {}};
    with.roots.reserve(roots.size());
    for (const RootIndex root : roots) {
        with.roots.push_back({root, tree.root_triangles.at(root)});
    }
    return with;
}

} // namespace

std::uint64_t
held_triangles(const BlockPlan& plan, std::uint32_t slot, const ScenarioRoots& roots) {
    std::uint64_t held = 0;
    for (const TreeRoots& side : roots) {
        held += plan.tree(side.tree).held.held(slot, side.roots);
    }
    return held;
}

bool DispatchScenario::is_lost_for_good() const {
    return losses.count() >= losses_max();
}

bool DispatchScenario::is_suspect() const {
    return losses.count() + 1 == limits::scenario_losses_max;
}

std::vector<PositionRange> UnsentPositions::all() const {
    std::vector<PositionRange> all;
    for (const GivenRange& range : ranges_) {
        all.push_back(range.positions);
    }
    return all;
}

void UnsentPositions::add(GivenRange given, std::uint64_t after) {
    CD_CHECK(given.positions.count != 0);
    count_ += given.positions.count;
    after_ = after;
    ranges_.push_back(std::move(given));
}

void UnsentPositions::put_back(const PositionSet& positions,
                               const std::shared_ptr<const PoseWindow>& window) {
    for (const PositionRange& run : std::views::reverse(positions.runs())) {
        ranges_.push_front({run, window});
    }
    count_ += positions.count();
}

GivenRange UnsentPositions::take_first(std::uint64_t most) {
    GivenRange& front = ranges_.front();
    GivenRange taken = front;
    taken.positions.count = std::min(taken.positions.count, most);
    count_ -= taken.positions.count;
    front.positions = {taken.positions.end(), front.positions.count - taken.positions.count};
    if (front.positions.count == 0) {
        ranges_.pop_front();
    }
    return taken;
}

bool UnsentPositions::remove(const PositionSet& positions) {
    const std::uint64_t before = count_;
    for (std::size_t left = ranges_.size(); left != 0; --left) {
        GivenRange range = std::move(ranges_.front());
        ranges_.pop_front();
        count_ -= range.positions.count;
        PositionSet rest = range.positions;
        rest.remove(positions);
        for (const PositionRange& run : rest.runs()) {
            ranges_.push_back({run, range.window});
        }
        count_ += rest.count();
    }
    return count_ != before;
}

std::vector<PositionRange> UnsentPositions::take_all() {
    std::vector<PositionRange> taken = all();
    ranges_.clear();
    count_ = 0;
    return taken;
}

DispatchJob::DispatchJob(JobId job,
                         const ClusterOptions& job_options,
                         DispatchTrees job_trees,
                         std::unique_ptr<MatchingPolicy> matching)
    : id(job), options(job_options), trees(std::move(job_trees)), policy(std::move(matching)) {}
DispatchJob::~DispatchJob() = default;

DispatchScenario& DispatchJob::at(std::uint64_t position) {
    return unanswered_one(scenarios, position);
}

const DispatchScenario& DispatchJob::at(std::uint64_t position) const {
    return unanswered_one(scenarios, position);
}

DispatchScenario DispatchJob::scenario_of(const AnalysedScenario& analysed) const {
    DispatchScenario scenario;
    scenario.roots = {with_triangles(trees.of(analysed.body_a), analysed.roots_a),
                      with_triangles(trees.of(analysed.body_b), analysed.roots_b)};
    scenario.weight = {analysed.bytes,
                       analysed.predicted_ns != 0 ? analysed.predicted_ns
                                                  : limits::scenario_ns_unknown};
    scenario.losses = analysed.losses;
    return scenario;
}

} // namespace cd
