// Results of the question how far the bodies are apart, for tests of what users see.
#pragma once

#include "common/job/result/result.hpp"

#include <vector>

namespace cd::tests {

/// Returns four results: scenario 0 is 0.25 apart, along x; 1 is in contact; 2 is farther apart
/// than asked for; 3 is inside, 0.125 apart along z.
inline std::vector<ScenarioResult> distance_results() {
    std::vector<ScenarioResult> results(4);
    for (std::size_t i = 0; i < results.size(); ++i) {
        results[i].index = i;
        results[i].question = Question::Distance;
        results[i].level = Level::Any;
    }
    results[0].nearest = NearestWitness{0.25, 3, 7, 27, {10, 0, 0}, {0.5, 0, 0}, {0.75, 0, 0}};
    results[1].kind = ScenarioClass::Contact;
    results[3].kind = ScenarioClass::Inside;
    results[3].nearest = NearestWitness{0.125, 0, 5, 0, {0, 0, 1}, {0, 0, 0}, {0, 0, 0.125}};
    return results;
}

} // namespace cd::tests
