// Checks the results that workers send, and settles the parts of their classes that depend on whole
// bodies (settle.hpp).
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/ordered_poses.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/result.hpp"
#include "common/job/statistics.hpp"
#include "master/base/position_set.hpp"
#include "master/base/result_batch.hpp"
#include "master/compute/task_content.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace cd {

/// Checked and settled results: those of a message, or of the master.
struct TakenResults {
    ResultBatch results;
    /// Of each result, the position of its scenario in the job's hand-out order.
    std::vector<std::uint64_t> positions_of_rows;
    JobStatistics cost;         ///< Cost to the master: analysis and settling.
    ContactMap map;             ///< Joint map of all results; empty unless the query asks for maps.
    PositionSet positions = {}; ///< Positions of all results, if these came in one message.

    void add(const ScenarioResult& result, std::uint64_t position, const JobStatistics& spent);
};

/// Decodes and checks the results of a message, which may be forged, and settles their classes.
/// Errors: BadFrame or TooLarge for an invalid record, a question, a level, a clearance or bodies
/// that were not asked for, pairs or a distance that the query cannot have, a scenario that is not
/// in the task, or a map that cannot belong to the results.
[[nodiscard]] Result<TakenResults> take_results(const TaskContent& task, const Results& results);

/// `take_results`, or its replacement in a simulation. Any thread may call it.
using ResultCheck = std::function<Result<TakenResults>(const TaskContent&, const Results&)>;

/// Like `take_results`, but for an unknown task, so that any scenario of the job may occur, once.
[[nodiscard]] Result<TakenResults> take_late_results(JobId job,
                                                     std::shared_ptr<const JobMaterial> material,
                                                     OrderedPoses& poses,
                                                     const Results& results);

} // namespace cd
