#include "worker/execution/walk.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// The roots of a tree that at least one scenario uses.
class UsedRoots {
  public:
    explicit UsedRoots(std::uint32_t root_count) : used_by_(root_count, 0) {}

    /// Records that a scenario uses `root`, scenario by scenario; numbers start at 1. Returns true
    /// if the root is new to `scenario`.
    bool add(RootIndex root, std::uint32_t scenario) {
        return std::exchange(used_by_[root], scenario) != scenario;
    }
    void append_keys(TreeId tree, std::vector<SubtreeKey>& keys) const {
        for (RootIndex root = 0; root < used_by_.size(); ++root) {
            if (used_by_[root] != 0) {
                keys.push_back({tree, root});
            }
        }
    }

  private:
    std::vector<std::uint32_t> used_by_; ///< Last scenario to use each root; 0: none.
};

class Walker {
  public:
    explicit Walker(const Walk& walk)
        : walk_(walk),
          used_a_(walk.a->root_count()),
          used_b_of_its_own_(walk.b->root_count()),
          used_b_(walk.job->tree_a == walk.job->tree_b ? used_a_ : used_b_of_its_own_),
          expects_touch_(can_expect_touch(walk)),
          map_(walk.job->parts) {}

    /// Runs a scenario, or records that it waits for subtrees. Returns false if stopped.
    bool run(std::size_t which, const Scenario& scenario, const RunOptions& options) {
        ++scenario_;
        if (touching_ && gather({&*touching_, 1})) {
            const ScenarioRun run =
                run_on_subtrees(kept_, pairs_, scenario, walk_.job->query, options);
            if (run.is_stopped || run.result.kind == ScenarioClass::Contact) {
                return add(run);
            }
            walked_.finished.statistics += run.statistics;
        }
        return run_on_roots(which, scenario, options);
    }

    [[nodiscard]] Walked take() {
        walked_.finished.map = map_.take();
        used_a_.append_keys(walk_.job->tree_a, walked_.used);
        used_b_of_its_own_.append_keys(walk_.job->tree_b, walked_.used);
        return std::move(walked_);
    }

  private:
    /// Returns whether a contact below one pair of roots is the whole answer: at `level any`,
    /// for trees that never have too many colliding roots, which would be a failure.
    static bool can_expect_touch(const Walk& walk) {
        const Query& query = walk.job->query;
        return query.level == Level::Any &&
               std::uint64_t{walk.a->root_count()} * walk.b->root_count() <= limits::root_pairs_max;
    }

    /// Finds the colliding roots and runs the scenario, or records that it waits for subtrees.
    /// Returns false if stopped.
    bool run_on_roots(std::size_t which, const Scenario& scenario, const RunOptions& options) {
        Result<CollidingRoots> roots =
            query_roots(walk_.a->top(), walk_.b->top(), scenario, walk_.job->query);
        FinishedScenarios& finished = walked_.finished;
        if (!roots) {
            finished.add(encode_result(failed_result(scenario, walk_.job->query, roots.error())));
            return true;
        }
        finished.statistics.box_tests += roots.value().box_tests;
        if (!gather(roots.value().pairs)) {
            walked_.waiting.push_back({which, std::move(roots.value().pairs)});
            return true;
        }
        const ScenarioRun run = run_on_subtrees(kept_, pairs_, scenario, walk_.job->query, options);
        touching_.reset();
        if (expects_touch_ && kept_.touching) {
            touching_ = roots.value().pairs[*kept_.touching];
        }
        return add(run);
    }

    /// Adds a scenario's result. Returns false if stopped.
    bool add(const ScenarioRun& run) {
        if (run.is_stopped) {
            return false;
        }
        walked_.finished.add(encode_result(run.result));
        walked_.finished.statistics += run.statistics;
        map_.add(run.result, run.found);
        return true;
    }

    /// Collects the subtrees of the pairs. Returns false if a subtree is missing.
    bool gather(std::span<const RootPair> pairs) {
        pairs_.clear();
        std::uint64_t found = 0;
        for (const RootPair& pair : pairs) {
            const Subtree* const a = walk_.a->at(pair.a).get();
            const Subtree* const b = walk_.b->at(pair.b).get();
            if (a == nullptr || b == nullptr) {
                return false;
            }
            found += used_a_.add(pair.a, scenario_) ? 1 : 0;
            found += used_b_.add(pair.b, scenario_) ? 1 : 0;
            pairs_.push_back({a->view(), b->view()});
        }
        walked_.found += found;
        return true;
    }

    const Walk& walk_;
    UsedRoots used_a_;
    UsedRoots used_b_of_its_own_;
    UsedRoots& used_b_;  ///< `used_a_` if both bodies use one tree.
    bool expects_touch_; ///< Sets `touching_`.
    /// The pair of roots that touched last. Under a neighbouring pose it mostly touches again. Then
    /// the scenario spares the descent of the upper trees, which costs several times as much.
    std::optional<RootPair> touching_;
    std::uint32_t scenario_ = 0;
    std::vector<SubtreePair> pairs_;
    KeptSearch kept_;
    ContactMapSum map_;
    Walked walked_;
};

} // namespace

Scenario TaskScenarios::at(std::size_t which) const {
    if (list_ != nullptr) {
        return (*list_)[which];
    }
    return scenario_on(*job_->grid, first_ + which);
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
    const auto is_dropped = [&](std::uint64_t scenario) {
        return walk.job->dropped->contains(scenario) || walk.answered_elsewhere->contains(scenario);
    };
    RunOptions options;
    options.stop = [&] { return (stop && stop()) || is_dropped(clock.scenario()); };
    Walker walker(walk);
    std::size_t which = walk.begin;
    std::size_t unanswered = 0;
    for (; which < walk.end && !(stop && stop()); ++which) {
        const Scenario scenario = walk.scenarios.at(which);
        clock.begin(scenario.index);
        unanswered += !is_dropped(scenario.index) && walker.run(which, scenario, options) ? 0 : 1;
    }
    clock.end();
    Walked walked = walker.take();
    walked.left = walk.end - which + unanswered;
    walked.finished.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return walked;
}

} // namespace cd
