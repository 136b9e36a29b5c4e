#include "client/folder/motion_case.hpp"

#include "client/trees/body_trees.hpp"
#include "common/core/errors.hpp"
#include "common/job/run_scenario.hpp"

#include <string>
#include <utility>

namespace cd {

namespace {

/// Whether bodies at rest have the result that the motion says of them. An undecided motion says
/// nothing of its begin.
bool agrees(const ScenarioResult& at_rest, const ScenarioResult& of_motion) {
    return of_motion.kind == ScenarioClass::Undecided ||
           (at_rest.kind == of_motion.kind && at_rest.pair_count == of_motion.pair_count &&
            at_rest.near_count == of_motion.near_count && at_rest.pairs == of_motion.pairs);
}

} // namespace

Status rest_at_answers(PreparedJob& job,
                       CaseScenarios& scenarios,
                       TreeCache& cache,
                       ThreadPool& pool,
                       const StopCheck& stop) {
    if (!job.query.motion) {
        return Done{};
    }
    job.query.question = Question::Contacts;
    job.query.motion.reset();
    const auto trees = make_body_trees(job.meshes, TreeUse{.settles = true}, cache, pool);
    const ScenarioRunner runner(TreesByBody(trees), job.query, PairStage::Float, stop);
    for (std::size_t i = 0; i < scenarios.scenarios.size(); ++i) {
        ScenarioResult& result = scenarios.results[i];
        if (result.kind == ScenarioClass::Failed) {
            continue;
        }
        ScenarioRun run = runner.run(scenarios.scenarios[i]);
        if (run.is_stopped) {
            return interrupted();
        }
        if (!agrees(run.result, result)) {
            return bad_input("scenario " + std::to_string(result.index) +
                             " has other contacts here than in the run; `cdctl verify` tells "
                             "whether the run is right");
        }
        result = std::move(run.result);
    }
    return Done{};
}

} // namespace cd
