// A job in the dispatcher, and its scenarios that have no answer yet.
#pragma once

#include "common/core/id.hpp"
#include "common/tree/root_holders.hpp"
#include "master/base/instance_id.hpp"
#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/dispatch_inputs.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/job/job_meters.hpp"
#include "master/dispatch/workers/worker_buffers.hpp"
#include "master/dispatch/workers/worker_tasks.hpp"
#include "proto/messages/cluster_options.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace cd {

class MatchingPolicy;

/// Roots of a tree that a scenario touches, ascending, each with its triangle count.
struct TreeRoots {
    TreeId tree;
    std::vector<WeightedRoot> roots;
};

/// The roots of body A's tree, then of body B's, which may be the same tree.
using ScenarioRoots = std::array<TreeRoots, 2>;

/// Returns the triangles of a scenario's roots that the worker at a slot holds, over both trees.
[[nodiscard]] std::uint64_t
held_triangles(const BlockPlan& plan, std::uint32_t slot, const ScenarioRoots& roots);

/// State of an unanswered scenario.
enum class Whereabouts : std::uint8_t {
    Waiting,  ///< In the job's queue.
    Suspect,  ///< In the queue of suspects, for one last attempt alone on a worker.
    Buffered, ///< In a worker's buffer.
    Sent,     ///< In a task at a worker.
};

struct DispatchScenario {
    ScenarioRoots roots;
    ScenarioWeight weight;
    bool fetches = false; ///< The worker lacked some blocks of the scenario.
    Losses losses;        ///< Worker processes that were lost with the scenario.
    Whereabouts where = Whereabouts::Waiting;
    Assignment at;             ///< The worker if Buffered or Sent, and the task if Sent.
    std::uint32_t recalls = 0; ///< Number of times that the scenario was recalled and returned.

    /// True if the scenario was lost too often and must be given up.
    [[nodiscard]] bool is_lost_for_good() const;
    /// True if the next loss would make `is_lost_for_good` true.
    [[nodiscard]] bool is_suspect() const;
};

/// Positions that may go out without analysis, and are in no task.
class UnsentPositions {
  public:
    [[nodiscard]] bool is_empty() const { return ranges_.empty(); }
    /// Number of positions.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Number of positions and of the job's scenarios that follow them.
    [[nodiscard]] std::uint64_t rest() const { return count_ + after_; }
    /// The positions in the order in which they go out.
    [[nodiscard]] std::vector<PositionRange> all() const;

    /// `after`: number of the job's scenarios that follow these positions.
    void add(GivenRange given, std::uint64_t after);
    /// Puts positions that were in a task back at the head.
    void put_back(const PositionSet& positions, const std::shared_ptr<const PoseWindow>& window);
    /// Sets the number of scenarios that follow to 0 until the next `add`: they are analysed.
    void nothing_follows() { after_ = 0; }
    /// Removes and returns at most `most` of the first positions; there must be some.
    GivenRange take_first(std::uint64_t most);
    std::vector<PositionRange> take_all();
    /// Removes the given positions where they are unsent, and returns whether any was.
    bool remove(const PositionSet& positions);

  private:
    std::deque<GivenRange> ranges_; ///< None is empty.
    std::uint64_t count_ = 0;
    std::uint64_t after_ = 0;
};

/// Sums over the workers that process ranges of a job. Counting them takes a look at every worker.
struct RangeTotals {
    double rate = 0;         ///< Scenarios/s of all workers that take work.
    double unclaimed = 0;    ///< Scenarios/s of unclaimed workers.
    double quickest = 0;     ///< Best rate per thread, unclaimed workers.
    double quickest_but = 0; ///< Second-best rate per thread, unclaimed workers.
    WorkerId quickest_worker;
    std::uint64_t in_flight = 0; ///< Unanswered scenarios at unclaimed workers.
    std::uint64_t threads = 0;   ///< Threads of all workers that take work.
    std::uint64_t at_once = 0;   ///< Sum of the workers' ranges far from the end of the job.
    std::size_t events_left = 1; ///< Number of events after which these totals are dropped.
};

/// Analysed scenarios of a job on their way to the workers.
struct JobInput {
    std::uint64_t unsent = 0; ///< Scenarios that wait, are suspects, or are buffered.
    bool is_paused = false;   ///< No more come for now.
};

struct DispatchJob {
    DispatchJob(JobId job,
                const ClusterOptions& job_options,
                DispatchTrees job_trees,
                std::unique_ptr<MatchingPolicy> matching);
    ~DispatchJob();
    DispatchJob(const DispatchJob&) = delete;
    DispatchJob& operator=(const DispatchJob&) = delete;

    /// Returns the scenario at a position, which must be analysed and unanswered.
    [[nodiscard]] DispatchScenario& at(std::uint64_t position);
    [[nodiscard]] const DispatchScenario& at(std::uint64_t position) const;
    /// Makes the scenario's entry, in the state Waiting. Does not add it.
    [[nodiscard]] DispatchScenario scenario_of(const AnalysedScenario& analysed) const;

    JobId id;
    ClusterOptions options;
    DispatchTrees trees;
    std::unique_ptr<MatchingPolicy> policy;
    /// All unanswered analysed scenarios, by position.
    std::unordered_map<std::uint64_t, DispatchScenario> scenarios;
    std::deque<std::uint64_t> waiting;
    JobInput input;
    UnsentPositions unsent;
    RangePace range_pace;
    mutable std::optional<RangeTotals> range_totals; ///< Cache of `RangeSender::totals`.
    MissingMeter missing;
    CopyBudget copies;
};

} // namespace cd
