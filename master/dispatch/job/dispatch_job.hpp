// A job in the dispatcher, and its scenarios that have no answer yet.
#pragma once

#include "common/core/id.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/tree/root_holders.hpp"
#include "master/base/instance_id.hpp"
#include "master/dispatch/dispatch_inputs.hpp"
#include "master/dispatch/dispatch_tree.hpp"
#include "master/dispatch/job/job_meters.hpp"
#include "master/dispatch/workers/worker_buffers.hpp"
#include "proto/messages/cluster_options.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace cd {

class MatchingPolicy;

/// Roots of both trees that a scenario touches, ascending, each with its triangle count.
struct ScenarioRoots {
    std::vector<WeightedRoot> a;
    std::vector<WeightedRoot> b;
};

/// State of an unanswered scenario.
enum class Whereabouts : std::uint8_t {
    Waiting,  ///< In its job's queue.
    Suspect,  ///< In the queue for one last, separate attempt.
    Buffered, ///< In a worker's buffer.
    Sent,     ///< In a task at a worker.
};

struct Assignment {
    WorkerId worker;
    TaskId task;
};

struct DispatchScenario {
    ScenarioRoots roots;
    ScenarioWeight weight;
    bool fetches = false; ///< The worker lacked some blocks.
    Losses losses;        ///< Tasks that ended without its answer.
    Whereabouts where = Whereabouts::Waiting;
    WorkerId worker;                ///< Set if Buffered or Sent.
    TaskId task;                    ///< Set if Sent.
    std::optional<Assignment> copy; ///< Speculative copy; only if Sent.
    bool was_copied = false;
    std::uint32_t recalls = 0; ///< Number of times it was returned after a recall.

    /// A scenario that was lost may kill its worker, so it is not copied.
    [[nodiscard]] bool may_be_copied() const { return !was_copied && losses.none(); }
    [[nodiscard]] bool is_in(TaskId one) const {
        return where == Whereabouts::Sent && (task == one || (copy && copy->task == one));
    }
    /// True if the scenario was lost too often and must be given up.
    [[nodiscard]] bool is_lost_for_good() const;
    /// True if its next loss would be the last.
    [[nodiscard]] bool is_suspect() const;
    /// Removes it, unanswered, from a task that it is in. True: its copy remains in another task.
    bool leave_task(TaskId one);
};

/// Ranges of order positions that were given and not sent.
class UnsentPlaces {
  public:
    [[nodiscard]] bool is_empty() const { return ranges_.empty(); }
    /// Number of positions.
    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// Positions, and scenarios of the job that follow them.
    [[nodiscard]] std::uint64_t rest() const { return count_ + after_; }
    [[nodiscard]] std::vector<PlaceRange> all() const { return {ranges_.begin(), ranges_.end()}; }

    /// `after` more scenarios of the job follow these positions.
    void add(const PlaceRange& places, std::uint64_t after);
    /// No more positions follow these: the others are analysed, or come with the next range.
    void nothing_follows() { after_ = 0; }
    /// Takes at most `most` of the first positions; there must be some.
    PlaceRange take_first(std::uint64_t most);
    std::vector<PlaceRange> take_all();

  private:
    std::deque<PlaceRange> ranges_;
    std::uint64_t count_ = 0;
    std::uint64_t after_ = 0;
};

/// How fast all workers process ranges of a job, and how much is left.
struct PlaceTotals {
    double rate = 0;         ///< Scenarios/s of all workers that take work.
    double unclaimed = 0;    ///< Scenarios/s of unclaimed workers.
    double quickest = 0;     ///< Best rate per thread, unclaimed workers.
    double quickest_but = 0; ///< Second-best worker's rate per thread.
    WorkerId quickest_worker;
    std::uint64_t left = 0; ///< Unanswered: unsent, or at an unclaimed worker.
};

struct DispatchJob {
    DispatchJob(JobId job,
                const ClusterOptions& job_options,
                DispatchTree tree_a,
                DispatchTree tree_b,
                std::unique_ptr<MatchingPolicy> matching);
    ~DispatchJob();
    DispatchJob(const DispatchJob&) = delete;
    DispatchJob& operator=(const DispatchJob&) = delete;

    /// The scenario must be unanswered, as all scenarios in buffers, tasks and queues are.
    [[nodiscard]] DispatchScenario& at(std::uint64_t index);
    [[nodiscard]] const DispatchScenario& at(std::uint64_t index) const;
    [[nodiscard]] bool uses(TreeId tree) const { return a.tree == tree || b.tree == tree; }
    /// The scenario as it is before it has a worker.
    [[nodiscard]] DispatchScenario scenario_of(const AnalysedScenario& analysed) const;

    JobId id;
    ClusterOptions options;
    DispatchTree a;
    DispatchTree b;
    std::unique_ptr<MatchingPolicy> policy;
    std::unordered_map<std::uint64_t, DispatchScenario> scenarios; ///< All unanswered scenarios.
    std::deque<std::uint64_t> waiting;
    UnsentPlaces places;
    RangePace range_pace;
    mutable std::optional<PlaceTotals> place_totals; ///< Computed once per event.
    MissingMeter missing;
    CopyBudget copies;
};

} // namespace cd
