// The scenarios of a task as sent. Only this header converts between their positions in the job's
// hand-out order, which name them on the master, and their indices as submitted, which name them to
// workers.
#pragma once

#include "common/core/id.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/query.hpp"
#include "common/job/trees_by_body.hpp"
#include "master/base/position_set.hpp"
#include "master/compute/analyser.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// Inputs for checking and settling the results of a job.
struct JobMaterial {
    BodyTrees trees;
    Query query;
    std::shared_ptr<const Settler> settler; ///< Settles results; made for `trees`.
    /// The parts by which contacts are summed; null if they are not (`sums_contacts`).
    std::shared_ptr<const BodyPartRuns> parts = {};
    std::vector<double> radii = {}; ///< Of each body, in a job of motions; else empty.

    [[nodiscard]] std::uint64_t triangles_of(std::uint32_t body) const {
        return trees[body]->mesh().triangles().size();
    }
};

/// Scenarios that were sent without analysis.
struct RangeContent {
    PositionRange positions;
    std::shared_ptr<const PoseWindow> window; ///< Null for a grid.
    std::shared_ptr<OrderedPoses> order;

    /// The position of the scenario with this index; empty if it is not in the range.
    [[nodiscard]] std::optional<std::uint64_t> position_of(std::uint64_t index) const;
    /// The bodies and step of the scenario at a position of the range.
    [[nodiscard]] ScenarioBodies bodies_at(std::uint64_t position) const {
        return window == nullptr ? ScenarioBodies{} : window->bodies_at(position);
    }
    /// The scenario at a position of the range.
    [[nodiscard]] Scenario scenario_at(std::uint64_t position) const;
};

/// The scenarios of a task, and the data to check their results.
struct TaskContent {
    JobId job;
    std::shared_ptr<const JobMaterial> material;
    /// The scenarios if they are analysed, ascending by position.
    std::vector<std::shared_ptr<const Analysis>> analyses;
    std::optional<RangeContent> range; ///< The scenarios if not analysed; `analyses` is empty then.

    [[nodiscard]] std::uint64_t count() const {
        return range ? range->positions.count : analyses.size();
    }
    /// The message that sends the task.
    [[nodiscard]] WorkUnit unit(TaskId task) const;
    /// The index, as submitted, of the task's scenario at a position.
    [[nodiscard]] std::uint64_t index_of(std::uint64_t position) const;
    /// The message that recalls the positions of the task. There must be at least one.
    [[nodiscard]] Recall recall(TaskId task, const PositionSet& positions) const;
    /// The positions that the worker says it has returned.
    [[nodiscard]] PositionSet returned(const Recalled& recalled) const;
};

} // namespace cd
