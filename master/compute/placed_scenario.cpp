#include "master/compute/placed_scenario.hpp"

namespace cd {

Result<PlacedScenario> read_one(OrderedPoses& poses, std::uint64_t index) {
    if (poses.grid() != nullptr) {
        return PlacedScenario{scenario_on(*poses.grid(), index), index};
    }
    // A window orders scenarios among themselves, so it has an index where it has the position.
    const auto window = poses.window_of(index);
    if (!window) {
        return window.error();
    }
    const std::uint64_t position = window.value()->place_of(index);
    return PlacedScenario{window.value()->at({position, 1}).front(), position};
}

} // namespace cd
