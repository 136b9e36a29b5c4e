#include "master/compute/placed_scenario.hpp"

namespace cd {

Result<PlacedScenario> read_one(OrderedPoses& poses, std::uint64_t index) {
    if (poses.grid() != nullptr) {
        return PlacedScenario{scenario_on(*poses.grid(), index), index};
    }
    const auto window = poses.window_of(index);
    if (!window) {
        return window.error();
    }
    const std::uint64_t position = window.value()->position_of(index);
    const Result<Scenario> scenario = window.value()->at(position);
    return scenario ? Result(PlacedScenario{scenario.value(), position}) : scenario.error();
}

} // namespace cd
