// Checks what a worker sends as results, and settles what only the whole bodies can tell.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/query.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/obb_tree.hpp"
#include "master/jobs/submitter.hpp"
#include "proto/messages/work_messages.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// What results of a job are checked and settled with.
struct JobMaterial {
    std::shared_ptr<const ObbTree> a;
    std::shared_ptr<const ObbTree> b;
    Query query;
    std::shared_ptr<const Settler> settler; ///< Of these trees.
};

/// The scenarios of a range: places on a grid, or of a window.
struct RangeContent {
    PlaceRange places;
    std::shared_ptr<const PoseWindow> window; ///< Null: on the grid.
    std::shared_ptr<OrderedPoses> order;

    /// Nothing for a scenario that is not among them.
    [[nodiscard]] std::optional<Scenario> scenario(std::uint64_t index) const;
};

/// What a task consists of.
struct TaskContent {
    JobId job;
    std::shared_ptr<const JobMaterial> material;
    std::vector<std::shared_ptr<const Analysis>> scenarios; ///< In the order sent.
    std::optional<RangeContent> range;                      ///< Instead of these.
};

/// A result with its canonical record and the record's hash.
struct TakenResult {
    ScenarioResult result;
    Bytes record;
    Sha256 digest;
    JobStatistics cost; ///< What the scenario cost here: its analysis, and settling the result.
};

[[nodiscard]] TakenResult take_result(ScenarioResult result, const JobStatistics& cost);

/// The results of a message.
struct TakenResults {
    std::vector<TakenResult> results;
    ContactMap map; ///< Of all of them, where the query is for maps.
};

/// The results of a message, each settled. The bytes may be hostile. Errors: BadFrame, TooLarge;
/// for a record that is none, of another level or bodies than asked, or of a scenario that is not
/// in the task; and for a map that cannot be theirs.
[[nodiscard]] Result<TakenResults> take_results(const TaskContent& task, const Results& results);

/// The same of a task that is not known: poses are looked up among all those of the job.
[[nodiscard]] Result<TakenResults> take_late_results(JobId job,
                                                     std::shared_ptr<const JobMaterial> material,
                                                     PoseSource& poses,
                                                     const Results& results);

} // namespace cd
