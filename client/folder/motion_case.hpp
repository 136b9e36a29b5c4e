// Turns motions of a run into bodies at rest, for a case of their own.
#pragma once

#include "client/folder/extracted_case.hpp"
#include "client/job/prepared_job.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"

namespace cd {

/// Replaces the motions of a job of two bodies by bodies at rest under the poses of the motions'
/// answers: at the event, or at the begin if no event is known. The job asks for contacts then, and
/// the scenarios, which are at rest already (`at_answer`), are run here for their results. Failed
/// scenarios keep their results. A job without motions stays as it is. Errors: BadInput if
/// a result contradicts the run's; Interrupted.
[[nodiscard]] Status rest_at_answers(PreparedJob& job,
                                     CaseScenarios& scenarios,
                                     TreeCache& cache,
                                     ThreadPool& pool,
                                     const StopCheck& stop);

} // namespace cd
