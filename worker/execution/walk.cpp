#include "worker/execution/walk.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/distance_looks.hpp"
#include "common/job/query_roots.hpp"
#include "common/job/run_motion.hpp"
#include "common/job/run_scenario.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
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
    /// Records that a scenario uses all roots.
    void add_all(std::uint32_t scenario) { std::ranges::fill(used_by_, scenario); }
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
    explicit Walker(const Walk& walk) : walk_(walk), map_(walk.job->parts) {}

    /// Runs a scenario, or records that it waits for subtrees. Returns false if stopped.
    bool run(std::size_t which, const Scenario& scenario, const RunOptions& options) {
        ++scenario_;
        turn_to(scenario);
        if (joined_ != nullptr) {
            return run_on_joined(scenario, options);
        }
        if (touching_ && gather({&*touching_, 1})) {
            const ScenarioRun run = run_on_pairs(scenario, options);
            if (run.is_stopped || run.result.kind == ScenarioClass::Contact) {
                return add(run, 1, 1);
            }
            walked_.finished.statistics += run.statistics;
        }
        return run_on_roots(which, scenario, options);
    }

    [[nodiscard]] Walked take() {
        give_back_joined();
        walked_.finished.map = map_.take();
        for (const auto& [tree, roots] : used_) {
            roots.append_keys(tree, walked_.used);
        }
        return std::move(walked_);
    }

  private:
    /// The tree of one of a scenario's bodies.
    struct Side {
        TreeId id;
        const PartialObbTree* tree = nullptr;
        UsedRoots* used = nullptr;
        std::shared_ptr<const WideTree> joined; ///< Null if there is none.

        [[nodiscard]] CutBodies::Body cut() const {
            return {tree->top(), [this](RootIndex root) { return tree->at(root).get(); }};
        }
    };

    /// Turns to the trees of a scenario's bodies, which are mostly those of the scenario before.
    void turn_to(const Scenario& scenario) {
        const TreeId a = walk_.job->tree_a(scenario);
        const TreeId b = walk_.job->tree_b(scenario);
        if (search_ != nullptr && a == a_.id && b == b_.id) {
            return;
        }
        a_ = side_of(a);
        b_ = side_of(b);
        search_ = &kept_.of(a, b);
        touching_.reset();
        give_back_joined();
        if (a_.joined != nullptr && b_.joined != nullptr && never_has_too_many_pairs()) {
            joined_ = walk_.job->joined_searches->take(a_.joined, b_.joined);
            a_.used->add_all(scenario_);
            b_.used->add_all(scenario_);
        }
    }

    void give_back_joined() {
        if (joined_ != nullptr) {
            walk_.job->joined_searches->give_back(std::move(joined_));
        }
    }

    [[nodiscard]] Side side_of(TreeId id) {
        const PartialObbTree* const tree = walk_.trees.at(id).get();
        const auto joined = walk_.joined.find(id);
        return {id,
                tree,
                &used_.try_emplace(id, tree->root_count()).first->second,
                joined == walk_.joined.end() ? nullptr : joined->second};
    }

    /// Returns whether the trees have too few roots for the failure of too many colliding pairs,
    /// which must not depend on whether a worker has joined the trees.
    [[nodiscard]] bool never_has_too_many_pairs() const {
        const std::uint64_t pairs = std::uint64_t{a_.tree->root_count()} * b_.tree->root_count();
        return pairs <= limits::root_pairs_max;
    }

    /// Runs a scenario on the joined trees, without a descent of the upper trees. Returns false if
    /// stopped.
    bool run_on_joined(const Scenario& scenario, RunOptions options) {
        walked_.found += a_.tree->root_count() + (a_.id == b_.id ? 0 : b_.tree->root_count());
        options.radii = radii_of(walk_.job->radii, scenario);
        // The whole bodies count as one pair of roots.
        return add(joined_->run(scenario, walk_.job->query, options), 1, 1);
    }

    /// Returns whether a contact below one pair of roots is the whole answer.
    [[nodiscard]] bool can_expect_touch() const {
        return walk_.job->query.level == Level::Any && never_has_too_many_pairs();
    }

    /// Finds the colliding roots and runs the scenario, or records that it waits for subtrees.
    /// Returns false if stopped.
    bool run_on_roots(std::size_t which, const Scenario& scenario, const RunOptions& options) {
        Result<CollidingRoots> roots = query_roots(a_.tree->top(),
                                                   b_.tree->top(),
                                                   scenario,
                                                   walk_.job->query,
                                                   radii_of(walk_.job->radii, scenario));
        FinishedScenarios& finished = walked_.finished;
        if (!roots) {
            finished.add(encode_result(failed_result(scenario, walk_.job->query, roots.error())));
            return true;
        }
        finished.statistics.box_tests += roots.value().box_tests;
        std::vector<RootPair>& pairs = roots.value().pairs;
        const std::size_t named = pairs.size();
        return looks_twice(walk_.job->query, pairs) && !holds(pairs)
                   ? look_twice(which, scenario, std::move(pairs), options)
                   : run_or_wait(which, scenario, std::move(pairs), named, options);
    }

    /// Runs a scenario that asks for the distance in two looks, or records that it waits for
    /// subtrees. The first look is at the nearest of `pairs`, and at all others whose subtrees are
    /// cached; the second at those that may be nearer than what was found. Returns false if
    /// stopped.
    bool look_twice(std::size_t which,
                    const Scenario& scenario,
                    std::vector<RootPair> pairs,
                    const RunOptions& options) {
        const TreeTop& top_a = a_.tree->top();
        const TreeTop& top_b = b_.tree->top();
        const std::size_t named = pairs.size();
        std::vector<RootPair> nearest = first_look(top_a, top_b, scenario.poses, pairs);
        if (!holds(nearest)) {
            walked_.waiting.push_back({which, std::move(nearest), true, named});
            return true;
        }
        std::vector<RootPair> held;
        std::ranges::copy_if(pairs, std::back_inserter(held), [this](const RootPair& pair) {
            return holds({&pair, 1});
        });
        const std::uint64_t found_before = walked_.found;
        gather(held);
        const ScenarioRun run = run_on_gathered(held, scenario, options);
        if (run.is_stopped || run.result.kind == ScenarioClass::Contact) {
            return add(run, named, pairs_.size());
        }
        walked_.finished.statistics += run.statistics;
        const auto& found = run.result.nearest;
        pairs = second_look(top_a,
                            top_b,
                            scenario.poses,
                            std::move(pairs),
                            found ? std::optional(found->distance) : std::nullopt);
        if (!holds(pairs)) {
            walked_.found = found_before; // Whoever gets the missing subtrees counts all.
        }
        return run_or_wait(which, scenario, std::move(pairs), named, options);
    }

    /// Runs a scenario on all pairs of roots that it needs, of `named` that may have the answer, or
    /// records that it waits for subtrees. Returns false if stopped.
    bool run_or_wait(std::size_t which,
                     const Scenario& scenario,
                     std::vector<RootPair> pairs,
                     std::size_t named,
                     const RunOptions& options) {
        if (!gather(pairs)) {
            const bool is_motion = walk_.job->query.question == Question::Motion;
            walked_.waiting.push_back({which, std::move(pairs), is_motion, named});
            return true;
        }
        return add(run_on_gathered(pairs, scenario, options), named, pairs_.size());
    }

    /// Runs a scenario on `pairs`, which are gathered, and notes the pair that touches.
    [[nodiscard]] ScenarioRun run_on_gathered(std::span<const RootPair> pairs,
                                              const Scenario& scenario,
                                              const RunOptions& options) {
        ScenarioRun run = run_on_pairs(scenario, options);
        touching_.reset();
        if (search_->touching && can_expect_touch()) {
            touching_ = pairs[*search_->touching];
        }
        return run;
    }

    /// Runs a scenario on the pairs gathered.
    [[nodiscard]] ScenarioRun run_on_pairs(const Scenario& scenario, RunOptions options) {
        const CutBodies cut(a_.cut(), b_.cut());
        options.radii = radii_of(walk_.job->radii, scenario);
        options.cut = walk_.job->query.question == Question::Motion ? &cut : nullptr;
        return run_on_subtrees(*search_, pairs_, scenario, walk_.job->query, options);
    }

    /// Adds a scenario's result, which has used `used` of the `named` pairs of roots. Returns false
    /// if stopped.
    bool add(const ScenarioRun& run, std::size_t named, std::size_t used) {
        if (run.is_stopped) {
            return false;
        }
        walked_.finished.add(encode_result(run.result));
        walked_.finished.statistics += run.statistics;
        walked_.finished.count_roots(walk_.job->query, named, used);
        map_.add(run.result, run.found);
        return true;
    }

    /// Returns whether no subtree of the pairs is missing.
    [[nodiscard]] bool holds(std::span<const RootPair> pairs) const {
        return std::ranges::all_of(pairs, [this](const RootPair& pair) {
            return a_.tree->at(pair.a) != nullptr && b_.tree->at(pair.b) != nullptr;
        });
    }

    /// Collects the subtrees of the pairs. Returns false if a subtree is missing.
    bool gather(std::span<const RootPair> pairs) {
        pairs_.clear();
        std::uint64_t found = 0;
        for (const RootPair& pair : pairs) {
            const Subtree* const a = a_.tree->at(pair.a).get();
            const Subtree* const b = b_.tree->at(pair.b).get();
            if (a == nullptr || b == nullptr) {
                return false;
            }
            found += a_.used->add(pair.a, scenario_) ? 1 : 0;
            found += b_.used->add(pair.b, scenario_) ? 1 : 0;
            pairs_.push_back({a->view(), b->view()});
        }
        walked_.found += found;
        return true;
    }

    const Walk& walk_;
    std::map<TreeId, UsedRoots> used_;
    KeptSearches<TreeId> kept_;
    // The trees of the last scenario's bodies, and their search in `kept_`.
    Side a_;
    Side b_;
    KeptSearch* search_ = nullptr;
    std::unique_ptr<JoinedSearch> joined_; ///< Used instead of `search_` if both trees are joined.
    /// The pair of their roots that touched last. Under a neighbouring pose it mostly touches
    /// again. Then the scenario spares the descent of the upper trees, which costs several times as
    /// much.
    std::optional<RootPair> touching_;
    std::uint32_t scenario_ = 0;
    std::vector<SubtreePair> pairs_;
    ContactMapSum map_;
    Walked walked_;
};

} // namespace

std::set<TreeId> TaskScenarios::trees(const WorkerJob& job) const {
    if (list_ == nullptr) { // A grid has poses of the bodies 0 and 1.
        return {job.trees[0], job.trees[1]};
    }
    std::set<TreeId> trees;
    for (const Scenario& scenario : *list_) {
        trees.insert({job.tree_a(scenario), job.tree_b(scenario)});
    }
    return trees;
}

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

void FinishedScenarios::count_roots(const Query& query, std::size_t named, std::size_t used) {
    if (query.question == Question::Distance) {
        statistics.effort += {0, 0, named, used};
    }
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
