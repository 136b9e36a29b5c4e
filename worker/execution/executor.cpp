#include "worker/execution/executor.hpp"

#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace cd {
namespace {

TreeView view_of(const std::vector<RootIndex>& roots,
                 const std::vector<std::shared_ptr<const Subtree>>& subtrees,
                 RootIndex root) {
    const auto place = std::lower_bound(roots.begin(), roots.end(), root) - roots.begin();
    return subtrees[static_cast<std::size_t>(place)]->view();
}

} // namespace

void Executor::submit(std::function<Continuation()> job) {
    pool_->post([this, job = std::move(job)] {
        Continuation then = job();
        bool is_first = false;
        {
            const std::lock_guard lock(mutex_);
            is_first = ended_.empty();
            ended_.push_back(std::move(then));
        }
        if (is_first) {
            asio::post(home_, [this] { hand_over(); });
        }
    });
}

void Executor::hand_over() {
    std::vector<Continuation> ended;
    {
        const std::lock_guard lock(mutex_);
        ended.swap(ended_);
    }
    for (const Continuation& then : ended) {
        then();
    }
}

std::optional<FinishedScenarios> execute(const ReadyScenario& ready, const StopCheck& stop) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<SubtreePair> pairs;
    pairs.reserve(ready.pairs.size());
    for (const RootPair& pair : ready.pairs) {
        pairs.push_back({view_of(ready.roots_a, ready.subtrees_a, pair.a),
                         view_of(ready.roots_b, ready.subtrees_b, pair.b)});
    }
    RunOptions options;
    options.stop = stop;
    options.radii = ready.radii;
    const ScenarioRun run = run_on_subtrees(pairs, ready.scenario, *ready.query, options);
    if (run.is_stopped) {
        return std::nullopt;
    }
    FinishedScenarios finished;
    finished.add(encode_result(run.result));
    finished.statistics = run.statistics;
    finished.count_roots(*ready.query, ready.named, ready.pairs.size());
    ContactMapSum map(ready.parts);
    map.add(run.result, run.found);
    finished.map = map.take();
    finished.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return finished;
}

} // namespace cd
