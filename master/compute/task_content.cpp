#include "master/compute/task_content.hpp"

#include "common/core/check.hpp"
#include "common/job/packed_scenarios.hpp"

#include <algorithm>

namespace cd {

std::optional<std::uint64_t> RangeContent::position_of(std::uint64_t index) const {
    if (window != nullptr && !window->has(index)) {
        return std::nullopt;
    }
    const std::uint64_t position = window == nullptr ? index : window->position_of(index);
    const bool is_here = position >= positions.first && position < positions.end();
    return is_here ? std::optional(position) : std::nullopt;
}

Scenario RangeContent::scenario_at(std::uint64_t position) const {
    if (window == nullptr) {
        return scenario_on(*order->grid(), position); // On a grid, position and index are equal.
    }
    // `PoseSpool` has checked the pose: when it came or when the master started, and its checksum
    // when it was read.
    const Result<Scenario> scenario = window->at(position);
    CD_CHECK(scenario);
    return scenario.value();
}

WorkUnit TaskContent::unit(TaskId task) const {
    WorkUnit unit{task, job, 0, count(), {}, {}, {}, 0};
    if (range && range->window == nullptr) {
        unit.first = range->positions.first;
        return unit;
    }
    if (range) {
        unit.scenarios = range->window->packed(range->positions);
        return unit;
    }
    std::vector<Scenario> scenarios;
    unit.pair_offsets.push_back(0);
    for (const auto& analysis : analyses) {
        scenarios.push_back(analysis->scenario);
        unit.pairs.insert(unit.pairs.end(), analysis->pairs.begin(), analysis->pairs.end());
        unit.pair_offsets.push_back(static_cast<std::uint32_t>(unit.pairs.size()));
    }
    unit.scenarios = pack_scenarios(scenarios);
    return unit;
}

std::uint64_t TaskContent::index_of(std::uint64_t position) const {
    if (range) {
        return range->window == nullptr ? position : range->window->index_at(position);
    }
    const auto found = std::ranges::lower_bound(
        analyses, position, {}, [](const auto& analysis) { return analysis->position; });
    const bool task_has_position = found != analyses.end() && (*found)->position == position;
    CD_CHECK(task_has_position);
    return (*found)->scenario.index;
}

Recall TaskContent::recall(TaskId task, const PositionSet& positions) const {
    if (range) {
        return {task, {}, positions.runs().front().first - range->positions.first};
    }
    Recall recall{task, {}, 0};
    for (const std::uint64_t position : positions.list()) {
        recall.scenarios.push_back(index_of(position));
    }
    std::ranges::sort(recall.scenarios);
    return recall;
}

PositionSet TaskContent::returned(const Recalled& recalled) const {
    PositionSet positions;
    if (range) {
        const std::uint64_t kept = std::min(recalled.kept, range->positions.count);
        positions = PositionRange{range->positions.first + kept, range->positions.count - kept};
        for (const std::uint64_t index : recalled.scenarios) {
            if (const auto position = range->position_of(index)) {
                positions.add({*position, 1});
            }
        }
        return positions;
    }
    for (const auto& analysis : analyses) {
        if (std::ranges::binary_search(recalled.scenarios, analysis->scenario.index)) {
            positions.add({analysis->position, 1});
        }
    }
    return positions;
}

} // namespace cd
