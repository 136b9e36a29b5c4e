#include "worker/execution/task.hpp"

#include "common/core/limits/worker.hpp"
#include "common/core/timing/worker.hpp"
#include "common/job/distance_looks.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/run_motion.hpp"

#include <algorithm>
#include <utility>

namespace cd {
namespace {

Error bad_task(TaskId task, const std::string& why) {
    return {ErrorCode::BadFrame, "task " + std::to_string(task.value) + " " + why};
}

Result<TaskScenarios> scenarios_of(const WorkUnit& unit, std::shared_ptr<const WorkerJob> job) {
    if (unit.scenarios.empty()) {
        const std::uint64_t count = job->grid ? job->grid->count() : 0;
        if (unit.count > count || unit.first > count - unit.count) {
            return bad_task(unit.task, "names positions that the job's grid does not have");
        }
        return TaskScenarios(std::move(job), unit.first, unit.count);
    }
    auto list = unpack_scenarios(unit.scenarios, unit.count);
    if (!list) {
        return bad_task(unit.task, "has bad scenarios: " + list.error().detail);
    }
    if (list.value().size() != unit.count) {
        return bad_task(unit.task, "does not have the number of scenarios that it announces");
    }
    if (!std::ranges::all_of(list.value(), [&](const Scenario& scenario) {
            return are_bodies_of_job(scenario.body_a, scenario.body_b, job->trees.size());
        })) {
        return bad_task(unit.task, "names a body that the job does not have");
    }
    return TaskScenarios(std::move(list.value()));
}

/// Whether the trees of each scenario have the roots that an analysed unit lists for it.
bool has_roots(const WorkUnit& unit,
               const TaskScenarios& scenarios,
               const WorkerJob& job,
               const SubtreeCache& cache) {
    for (std::size_t i = 0; i + 1 < unit.pair_offsets.size(); ++i) {
        const Scenario scenario = scenarios.at(i);
        const std::uint32_t roots_a = cache.find(job.tree_a(scenario))->root_count();
        const std::uint32_t roots_b = cache.find(job.tree_b(scenario))->root_count();
        const std::uint32_t begin = unit.pair_offsets[i];
        const auto pairs = std::span(unit.pairs).subspan(begin, unit.pair_offsets[i + 1] - begin);
        if (!std::ranges::all_of(
                pairs, [&](RootPair pair) { return pair.a < roots_a && pair.b < roots_b; })) {
            return false;
        }
    }
    return true;
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
Task::make(WorkUnit unit, std::shared_ptr<const WorkerJob> job, const SubtreeCache& cache) {
    auto scenarios = scenarios_of(unit, job);
    if (!scenarios) {
        return scenarios.error();
    }
    if (!has_roots(unit, scenarios.value(), *job, cache)) {
        return bad_task(unit.task, "names a root that its tree does not have");
    }
    std::set<TreeId> trees = scenarios.value().trees(*job);
    Task task(unit.task, std::move(job), std::move(scenarios.value()), std::move(trees));
    if (unit.is_analysed()) {
        task.pairs_ = TaskPairs(std::move(unit.pair_offsets), std::move(unit.pairs));
        task.plan_walks(cache);
    } else {
        task.unwalked_end_ = unit.count;
    }
    return task;
}

Task::Task(TaskId id,
           std::shared_ptr<const WorkerJob> job,
           TaskScenarios scenarios,
           std::set<TreeId> trees)
    : id_(id),
      job_(std::move(job)),
      scenarios_(std::move(scenarios)),
      trees_(std::move(trees)),
      unanswered_(scenarios_.size()) {}

void Task::plan_walks(const SubtreeCache& cache) {
    const bool is_motion = job_->query.question == Question::Motion;
    for (std::size_t scenario = 0; scenario < scenario_count(); ++scenario) {
        if (is_motion) {
            const auto pairs = pairs_.of(scenario);
            pairs_.set({scenario, {pairs.begin(), pairs.end()}, true, pairs.size()});
        } else if (looks_twice(job_->query, pairs_.of(scenario)) &&
                   !std::ranges::all_of(roots_of(scenario),
                                        [&](const SubtreeKey& key) { return cache.has(key); })) {
            pairs_.set({scenario, {}, true, pairs_.named(scenario)});
        }
    }
}

std::vector<SubtreeKey> Task::roots_of(std::size_t scenario) const {
    const Scenario of = scenarios_.at(scenario);
    const auto pairs = pairs_.of(scenario);
    std::vector<SubtreeKey> keys;
    if (walks_again(scenario)) {
        keys = {{job_->tree_a(of), top_root}, {job_->tree_b(of), top_root}};
    }
    for (const RootIndex root : roots_of_a(pairs)) {
        keys.push_back({job_->tree_a(of), root});
    }
    for (const RootIndex root : roots_of_b(pairs)) {
        keys.push_back({job_->tree_b(of), root});
    }
    // Both bodies may share a tree.
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

ReadyScenario Task::ready(std::size_t scenario, const SubtreeCache& cache) const {
    const auto pairs = pairs_.of(scenario);
    ReadyScenario ready;
    ready.scenario = scenarios_.at(scenario);
    ready.query = {job_, &job_->query};
    ready.radii = radii_of(job_->radii, ready.scenario);
    ready.parts = job_->parts;
    ready.pairs.assign(pairs.begin(), pairs.end());
    ready.named = pairs_.named(scenario);
    ready.roots_a = roots_of_a(pairs);
    ready.roots_b = roots_of_b(pairs);
    ready.subtrees_a = subtrees_of(cache, job_->tree_a(ready.scenario), ready.roots_a);
    ready.subtrees_b = subtrees_of(cache, job_->tree_b(ready.scenario), ready.roots_b);
    return ready;
}

Walk Task::walk_of(std::size_t scenario, SubtreeCache& cache) const {
    const Scenario of = scenarios_.at(scenario);
    Walk walk{job_, scenarios_, scenario, scenario + 1, {}, answered_elsewhere_};
    for (const TreeId tree : {job_->tree_a(of), job_->tree_b(of)}) {
        walk.trees.emplace(tree, cache.snapshot(tree));
    }
    return walk;
}

Walk Task::next_walk(SubtreeCache& cache, unsigned threads) {
    const std::size_t unwalked = unwalked_end_ - walked_;
    const std::size_t share = unwalked / (2 * std::size_t{threads}) + 1;
    const double each = results_.seconds_per_scenario();
    const double fits = each > 0 ? timing::walk_seconds / each : 1;
    const auto most = static_cast<std::size_t>(
        std::clamp(fits, 1.0, static_cast<double>(limits::walk_scenarios_max)));
    const std::size_t begin = walked_;
    walked_ += std::min({unwalked, share, most});
    Walk walk{job_, scenarios_, begin, walked_, {}, answered_elsewhere_};
    for (const TreeId tree : trees_) {
        walk.trees.emplace(tree, cache.snapshot(tree));
    }
    return walk;
}

void Task::keep_first(std::size_t count) {
    const std::size_t end = std::clamp(count, walked_, unwalked_end_);
    drop(unwalked_end_ - end);
    unwalked_end_ = end;
}

bool Task::is_recalled(std::size_t scenario, const Recall& recall) const {
    const bool is_range = unwalked_end_ != 0;
    return is_range ? scenario >= recall.kept
                    : std::ranges::binary_search(recall.scenarios, index_of(scenario));
}

Recalled Task::given_back() const {
    return {id_, {given_back_.begin(), given_back_.end()}, unwalked_end_};
}

void Task::add(const FinishedScenarios& finished) {
    results_.add(finished);
    unanswered_ -= finished.count;
}

} // namespace cd
