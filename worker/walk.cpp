#include "worker/walk.hpp"

#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <chrono>

namespace cd {

namespace {

/// Which roots of a tree are used by any of the scenarios.
class UsedRoots {
  public:
    explicit UsedRoots(std::uint32_t root_count) : used_(root_count, false) {}

    void add(RootIndex root) { used_[root] = true; }
    void append_keys(TreeId tree, std::vector<SubtreeKey>& keys) const {
        for (RootIndex root = 0; root < used_.size(); ++root) {
            if (used_[root]) {
                keys.push_back({tree, root});
            }
        }
    }

  private:
    std::vector<bool> used_;
};

class Walker {
  public:
    explicit Walker(const Walk& walk)
        : walk_(walk), used_a_(walk.a->top().root_count()), used_b_(walk.b->top().root_count()) {}

    /// False when it was told to stop.
    bool run(std::size_t place, const Scenario& scenario, const RunOptions& options) {
        Result<CollidingRoots> roots =
            counted_colliding_roots(walk_.a->top(), walk_.b->top(), scenario.poses);
        FinishedScenarios& finished = walked_.finished;
        if (!roots) {
            finished.add(encode_result(failed_result(scenario, walk_.job->query, roots.error())));
            return true;
        }
        finished.statistics.box_tests += roots.value().box_tests;
        if (!gather(roots.value().pairs)) {
            walked_.waiting.push_back({place, std::move(roots.value().pairs)});
            return true;
        }
        const ScenarioRun run = run_on_subtrees(kept_, pairs_, scenario, walk_.job->query, options);
        if (run.is_stopped) {
            return false;
        }
        finished.add(encode_result(run.result));
        finished.statistics += run.statistics;
        return true;
    }

    [[nodiscard]] Walked take() {
        used_a_.append_keys(walk_.job->tree_a, walked_.used);
        used_b_.append_keys(walk_.job->tree_b, walked_.used);
        return std::move(walked_);
    }

  private:
    /// The subtrees of the pairs; false when one is not here.
    bool gather(std::span<const RootPair> pairs) {
        pairs_.clear();
        for (const RootPair& pair : pairs) {
            const Subtree* const a = walk_.a->at(pair.a).get();
            const Subtree* const b = walk_.b->at(pair.b).get();
            if (a == nullptr || b == nullptr) {
                return false;
            }
            used_a_.add(pair.a);
            used_b_.add(pair.b);
            pairs_.push_back({a->view(), b->view()});
        }
        return true;
    }

    const Walk& walk_;
    UsedRoots used_a_;
    UsedRoots used_b_;
    std::vector<SubtreePair> pairs_;
    KeptSearch kept_;
    Walked walked_;
};

} // namespace

Scenario TaskScenarios::at(std::size_t place) const {
    if (list_ != nullptr) {
        return (*list_)[place];
    }
    return scenario_on(*job_->grid, first_ + place);
}

void FinishedScenarios::add(const Bytes& record) {
    const auto size = static_cast<std::uint32_t>(record.size());
    const auto size_bytes = std::as_bytes(std::span(&size, 1));
    records.insert(records.end(), size_bytes.begin(), size_bytes.end());
    records.insert(records.end(), record.begin(), record.end());
    ++count;
}

Walked walk(const Walk& walk, const StopCheck& stop, ScenarioClock& clock) {
    const auto begin = std::chrono::steady_clock::now();
    const DroppedScenarios& dropped = *walk.job->dropped;
    RunOptions options;
    options.stop = [&] { return (stop && stop()) || dropped.contains(clock.scenario()); };
    Walker walker(walk);
    std::size_t place = walk.begin;
    std::size_t unanswered = 0;
    for (; place < walk.end && !(stop && stop()); ++place) {
        const Scenario scenario = walk.scenarios.at(place);
        clock.begin(scenario.index);
        unanswered +=
            !dropped.contains(scenario.index) && walker.run(place, scenario, options) ? 0 : 1;
    }
    clock.end();
    Walked walked = walker.take();
    walked.left = walk.end - place + unanswered;
    walked.finished.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return walked;
}

} // namespace cd
