#include "worker/task.hpp"

#include "common/job/packed_records.hpp"

#include <algorithm>
#include <utility>

namespace cd {
namespace {

Error bad_batch(const Batch& batch, const std::string& why) {
    return {ErrorCode::BadFrame, "task " + std::to_string(batch.task.value) + " " + why};
}

std::vector<std::shared_ptr<const Subtree>>
subtrees_of(const SubtreeCache& cache, TreeId tree, std::span<const RootIndex> roots) {
    std::vector<std::shared_ptr<const Subtree>> subtrees;
    subtrees.reserve(roots.size());
    for (const RootIndex root : roots) {
        subtrees.push_back(cache.at({tree, root}));
    }
    return subtrees;
}

} // namespace

Result<Task> Task::make(Batch batch, const SubtreeCache& cache) {
    const PartialObbTree* const a = cache.find(batch.tree_a);
    const PartialObbTree* const b = cache.find(batch.tree_b);
    if (a == nullptr || b == nullptr) {
        return bad_batch(batch, "names a tree that is not here");
    }
    const SubtreeForm form = cache.form_of(batch.tree_a);
    if (form != cache.form_of(batch.tree_b) ||
        (batch.query.tolerance > 0 && form != SubtreeForm::Binary)) {
        return bad_batch(batch, "has trees whose forms do not suit");
    }
    const std::uint32_t roots_a = a->top().root_count();
    const std::uint32_t roots_b = b->top().root_count();
    const bool in_range = std::all_of(batch.pairs.begin(), batch.pairs.end(), [&](RootPair pair) {
        return pair.a < roots_a && pair.b < roots_b;
    });
    if (!in_range) {
        return bad_batch(batch, "names a root that its tree does not have");
    }
    auto scenarios = unpack_scenarios(batch.scenarios);
    if (!scenarios) {
        return bad_batch(batch, "has bad scenarios: " + scenarios.error().detail);
    }
    if (scenarios.value().size() + 1 != batch.pair_offsets.size()) {
        return bad_batch(batch, "has pairs for another number of scenarios");
    }
    return Task(std::move(batch), std::move(scenarios.value()));
}

Task::Task(Batch batch, std::vector<Scenario> scenarios)
    : batch_(std::move(batch)),
      query_(std::make_shared<const Query>(std::move(batch_.query))),
      scenarios_(std::move(scenarios)),
      unanswered_(scenarios_.size()) {
    batch_.scenarios = {};
}

std::span<const RootPair> Task::pairs_of(std::size_t scenario) const {
    const std::uint32_t begin = batch_.pair_offsets[scenario];
    return std::span(batch_.pairs).subspan(begin, batch_.pair_offsets[scenario + 1] - begin);
}

std::vector<SubtreeKey> Task::roots_of(std::size_t scenario) const {
    std::vector<SubtreeKey> keys;
    for (const RootIndex root : roots_of_a(pairs_of(scenario))) {
        keys.push_back({batch_.tree_a, root});
    }
    for (const RootIndex root : roots_of_b(pairs_of(scenario))) {
        keys.push_back({batch_.tree_b, root});
    }
    // The bodies may share a mesh.
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

ReadyScenario Task::ready(std::size_t scenario, const SubtreeCache& cache) const {
    const auto pairs = pairs_of(scenario);
    ReadyScenario ready;
    ready.scenario = scenarios_[scenario];
    ready.query = query_;
    ready.pairs.assign(pairs.begin(), pairs.end());
    ready.roots_a = roots_of_a(pairs);
    ready.roots_b = roots_of_b(pairs);
    ready.subtrees_a = subtrees_of(cache, batch_.tree_a, ready.roots_a);
    ready.subtrees_b = subtrees_of(cache, batch_.tree_b, ready.roots_b);
    return ready;
}

void Task::add(const FinishedScenario& finished) {
    const auto size = static_cast<std::uint32_t>(finished.record.size());
    const auto size_bytes = std::as_bytes(std::span(&size, 1));
    records_.insert(records_.end(), size_bytes.begin(), size_bytes.end());
    records_.insert(records_.end(), finished.record.begin(), finished.record.end());
    ++results_.count;
    results_.statistics += finished.statistics;
    results_.compute_seconds += finished.seconds;
    --unanswered_;
}

std::optional<Results> Task::take_results() {
    if (results_.count == 0) {
        return std::nullopt;
    }
    Results results = std::exchange(results_, {});
    results.task = batch_.task;
    results.job = batch_.job;
    results.records = pack_records(records_);
    records_.clear();
    return results;
}

} // namespace cd
