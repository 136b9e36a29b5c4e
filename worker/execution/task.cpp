#include "worker/execution/task.hpp"

#include "common/core/limits/worker.hpp"
#include "common/job/result/packed_records.hpp"

#include <algorithm>
#include <utility>

namespace cd {
namespace {

Error bad_task(TaskId task, const std::string& why) {
    return {ErrorCode::BadFrame, "task " + std::to_string(task.value) + " " + why};
}

Result<std::vector<Scenario>> unpack(TaskId task, const Bytes& packed, std::uint64_t count_max) {
    auto scenarios = unpack_scenarios(packed, count_max);
    if (!scenarios) {
        return bad_task(task, "has bad scenarios: " + scenarios.error().detail);
    }
    return scenarios;
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

Result<Task>
Task::make(Batch batch, std::shared_ptr<const WorkerJob> job, const SubtreeCache& cache) {
    const std::uint32_t roots_a = cache.find(job->tree_a)->root_count();
    const std::uint32_t roots_b = cache.find(job->tree_b)->root_count();
    const bool in_range = std::all_of(batch.pairs.begin(), batch.pairs.end(), [&](RootPair pair) {
        return pair.a < roots_a && pair.b < roots_b;
    });
    if (!in_range) {
        return bad_task(batch.task, "names a root that its tree does not have");
    }
    auto scenarios = unpack(batch.task, batch.scenarios, batch.pair_offsets.size());
    if (!scenarios) {
        return scenarios.error();
    }
    if (scenarios.value().size() + 1 != batch.pair_offsets.size()) {
        return bad_task(batch.task, "has pairs for another number of scenarios");
    }
    Task task(batch.task, std::move(job), TaskScenarios(std::move(scenarios.value())));
    task.pairs_ = TaskPairs(std::move(batch.pair_offsets), std::move(batch.pairs));
    return task;
}

Result<Task> Task::make(const ScenarioRange& range, std::shared_ptr<const WorkerJob> job) {
    std::optional<TaskScenarios> scenarios;
    if (job->grid) {
        const std::uint64_t count = job->grid->count();
        if (range.count > count || range.first > count - range.count || !range.scenarios.empty()) {
            return bad_task(range.task, "names places that the job's grid does not have");
        }
        scenarios.emplace(job, range.first, range.count);
    } else {
        auto list = unpack(range.task, range.scenarios, range.count);
        if (!list) {
            return list.error();
        }
        if (list.value().size() != range.count) {
            return bad_task(range.task, "does not have the number of scenarios that it announces");
        }
        scenarios.emplace(std::move(list.value()));
    }
    Task task(range.task, std::move(job), std::move(*scenarios));
    task.unwalked_end_ = range.count;
    return task;
}

Task::Task(TaskId id, std::shared_ptr<const WorkerJob> job, TaskScenarios scenarios)
    : id_(id),
      job_(std::move(job)),
      scenarios_(std::move(scenarios)),
      unanswered_(scenarios_.size()) {}

std::vector<SubtreeKey> Task::roots_of(std::size_t scenario) const {
    std::vector<SubtreeKey> keys;
    for (const RootIndex root : roots_of_a(pairs_.of(scenario))) {
        keys.push_back({job_->tree_a, root});
    }
    for (const RootIndex root : roots_of_b(pairs_.of(scenario))) {
        keys.push_back({job_->tree_b, root});
    }
    // Both bodies may use one mesh.
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

ReadyScenario Task::ready(std::size_t scenario, const SubtreeCache& cache) const {
    const auto pairs = pairs_.of(scenario);
    ReadyScenario ready;
    ready.scenario = scenarios_.at(scenario);
    ready.query = {job_, &job_->query};
    ready.pairs.assign(pairs.begin(), pairs.end());
    ready.roots_a = roots_of_a(pairs);
    ready.roots_b = roots_of_b(pairs);
    ready.subtrees_a = subtrees_of(cache, job_->tree_a, ready.roots_a);
    ready.subtrees_b = subtrees_of(cache, job_->tree_b, ready.roots_b);
    return ready;
}

Walk Task::next_walk(SubtreeCache& cache, unsigned threads) {
    const std::size_t unwalked = unwalked_end_ - walked_;
    const std::size_t share = unwalked / (2 * std::size_t{threads}) + 1;
    const double each = results_.seconds_per_scenario();
    const double fits = each > 0 ? limits::walk_seconds / each : 1;
    const auto most = static_cast<std::size_t>(
        std::clamp(fits, 1.0, static_cast<double>(limits::walk_scenarios_max)));
    const std::size_t begin = walked_;
    walked_ += std::min({unwalked, share, most});
    return {job_,
            scenarios_,
            begin,
            walked_,
            cache.snapshot(job_->tree_a),
            cache.snapshot(job_->tree_b),
            answered_elsewhere_};
}

void Task::keep_places(std::size_t count) {
    const std::size_t end = std::clamp(count, walked_, unwalked_end_);
    drop(unwalked_end_ - end);
    unwalked_end_ = end;
}

Recalled Task::given_back() const {
    return {id_, {given_back_.begin(), given_back_.end()}, unwalked_end_};
}

void Task::add(const FinishedScenarios& finished) {
    results_.add(finished);
    unanswered_ -= finished.count;
}

} // namespace cd
