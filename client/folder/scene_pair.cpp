#include "client/folder/scene_pair.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/job/query.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace cd {

namespace {

using BodyNumbers = std::array<std::uint32_t, 2>;

/// Returns the bodies of all scenarios. Errors: BadInput if they differ.
Result<BodyNumbers> bodies_of(const PreparedJob& job, const CaseScenarios& scenarios) {
    const Scenario& first = scenarios.scenarios.front();
    for (const Scenario& scenario : scenarios.scenarios) {
        if (scenario.body_a != first.body_a || scenario.body_b != first.body_b) {
            return bad_input("scenario " + std::to_string(first.index) + " is of " +
                             job.names[first.body_a] + " and " + job.names[first.body_b] +
                             ", and scenario " + std::to_string(scenario.index) + " of " +
                             job.names[scenario.body_a] + " and " + job.names[scenario.body_b] +
                             "; extract them one by one");
        }
    }
    return BodyNumbers{first.body_a, first.body_b};
}

} // namespace

Result<ExtractedPair> pair_of_scene(const PreparedJob& job, CaseScenarios scenarios) {
    CD_CHECK(job.scene.has_value() && !scenarios.scenarios.empty());
    const BodyNumbers bodies = CD_TRY(bodies_of(job, scenarios));
    if (!ignored_of(job.query.ignored, bodies[0], bodies[1]).empty()) {
        return bad_input("rules ignore parts of " + job.names[bodies[0]] + " and " +
                         job.names[bodies[1]] +
                         ", which a case of two bodies does not have; draw the scenarios with "
                         "--as png");
    }
    ExtractedPair pair;
    pair.job.spec.name = job.spec.name;
    pair.job.spec.unit = job.spec.unit;
    pair.job.spec.file = job.spec.file;
    pair.job.query = job.query;
    pair.job.query.ignored.clear();
    pair.job.spec.query = pair.job.query;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        pair.job.spec.bodies[i] = job.scene->files[bodies[i]];
        pair.job.spec.bodies[i].name = job.names[bodies[i]];
        pair.job.names.push_back(job.names[bodies[i]]);
        pair.job.meshes.push_back(job.meshes[bodies[i]]);
    }
    pair.scenarios = std::move(scenarios);
    for (Scenario& scenario : pair.scenarios.scenarios) {
        scenario.body_a = 0;
        scenario.body_b = 1;
        scenario.step.reset();
    }
    for (ScenarioResult& result : pair.scenarios.results) {
        result.body_a = 0;
        result.body_b = 1;
        result.step.reset();
    }
    return pair;
}

} // namespace cd
