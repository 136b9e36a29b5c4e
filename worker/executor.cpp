#include "worker/executor.hpp"

#include "common/core/limits.hpp"

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

ScenarioResult too_large(const ScenarioResult& result, std::size_t bytes) {
    ScenarioResult failed;
    failed.index = result.index;
    failed.body_a = result.body_a;
    failed.body_b = result.body_b;
    failed.level = result.level;
    failed.kind = ScenarioClass::Failed;
    failed.failure = "its result takes " + std::to_string(bytes) +
                     " bytes, over the limit; set limit_pairs or ask for count";
    return failed;
}

} // namespace

Executor::Executor(asio::any_io_executor home, unsigned threads)
    : home_(std::move(home)), pool_(threads) {}

void Executor::submit(std::function<Continuation()> job) {
    pool_.post([this, job = std::move(job)] {
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

FinishedScenario execute(const ReadyScenario& ready) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<SubtreePair> pairs;
    pairs.reserve(ready.pairs.size());
    for (const RootPair& pair : ready.pairs) {
        pairs.push_back({view_of(ready.roots_a, ready.subtrees_a, pair.a),
                         view_of(ready.roots_b, ready.subtrees_b, pair.b)});
    }
    const ScenarioRun run = run_on_subtrees(pairs, ready.scenario, *ready.query);

    FinishedScenario finished;
    finished.record = encode_result(run.result);
    if (finished.record.size() > limits::result_record_bytes_max) {
        finished.record = encode_result(too_large(run.result, finished.record.size()));
    }
    finished.box_tests = run.statistics.box_tests;
    finished.triangle_tests = run.statistics.triangle_tests;
    finished.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return finished;
}

} // namespace cd
