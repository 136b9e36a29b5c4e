// Checks the results of workers, and settles the questions that need whole bodies.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/query.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/obb_tree.hpp"
#include "master/compute/analyser.hpp"
#include "proto/messages/work_messages.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// Inputs for checking and settling the results of a job.
struct JobMaterial {
    std::shared_ptr<const ObbTree> a;
    std::shared_ptr<const ObbTree> b;
    Query query;
    std::shared_ptr<const Settler> settler; ///< Settles results; made for trees `a` and `b`.
};

/// Scenarios of a range: positions in the job's hand-out order, on a grid or in a pose window.
struct RangeContent {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window; ///< Null for a grid.
    std::shared_ptr<OrderedPoses> order;

    /// The scenario with this index; empty if it is not in the range.
    [[nodiscard]] std::optional<Scenario> scenario(std::uint64_t index) const;
};

/// The scenarios of a task, and the data to check their results.
struct TaskContent {
    JobId job;
    std::shared_ptr<const JobMaterial> material;
    std::vector<std::shared_ptr<const Analysis>> scenarios; ///< For a batch, in the order sent.
    std::optional<RangeContent> range; ///< Set for a range, which has no `scenarios`.
};

/// A result with its canonical record and the record's hash.
struct TakenResult {
    ScenarioResult result;
    Bytes record;
    Sha256 digest;
    JobStatistics cost; ///< Cost to the master: analysis and settling.
};

[[nodiscard]] TakenResult take_result(ScenarioResult result, const JobStatistics& cost);

/// All results of a message.
struct TakenResults {
    std::vector<TakenResult> results;
    ContactMap map; ///< Joint map of all results; empty unless the query asks for maps.
};

/// Decodes, checks and settles the results of a message, which may be forged. Errors: BadFrame or
/// TooLarge for an invalid record, another level or other bodies than the job's, a scenario that is
/// not in the task, or a map that cannot belong to the results.
[[nodiscard]] Result<TakenResults> take_results(const TaskContent& task, const Results& results);

/// Like `take_results`, but for an unknown task, so that any scenario of the job may occur, once.
[[nodiscard]] Result<TakenResults> take_late_results(JobId job,
                                                     std::shared_ptr<const JobMaterial> material,
                                                     PoseSource& poses,
                                                     const Results& results);

} // namespace cd
