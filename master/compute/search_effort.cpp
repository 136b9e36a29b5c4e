#include "master/compute/search_effort.hpp"

#include "common/job/distance_looks.hpp"
#include "common/job/run_scenario.hpp"

namespace cd {

namespace {

/// Returns how many pairs of roots may have the distance that was found; all if there is none.
std::uint64_t
roots_used(const AnalysisInput& input, const Analysis& analysis, const ScenarioResult& result) {
    if (!result.nearest) {
        return analysis.pairs.size();
    }
    const Scenario& scenario = analysis.scenario;
    return second_look(*input.tops.at(scenario.body_a),
                       *input.tops.at(scenario.body_b),
                       scenario.poses,
                       analysis.pairs,
                       result.nearest->distance)
        .size();
}

} // namespace

std::optional<SearchEffort>
search_effort(const AnalysisInput& input, const Analysis& analysis, const StopCheck& stop) {
    const Question question = input.query.question;
    if (input.sketch || (question != Question::Motion && question != Question::Distance)) {
        return std::nullopt;
    }
    const ScenarioRunner runner(TreesByBody(input.trees), input.query, PairStage::Float, stop);
    const ScenarioRun run = runner.run(analysis.scenario);
    if (run.is_stopped || run.result.kind == ScenarioClass::Failed) {
        return std::nullopt;
    }
    SearchEffort effort = run.statistics.effort;
    if (question == Question::Distance) {
        effort.roots_named = analysis.pairs.size();
        effort.roots_used = roots_used(input, analysis, run.result);
    }
    return effort;
}

} // namespace cd
