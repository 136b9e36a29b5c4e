#include "client/compare/pose_subset.hpp"

#include "common/core/errors.hpp"

namespace cd {

Result<std::vector<Scenario>> PoseSubset::read(std::uint64_t first, std::uint64_t count) {
    std::vector<Scenario> scenarios;
    scenarios.reserve(count);
    while (scenarios.size() < count) {
        const std::uint64_t number = first + scenarios.size();
        std::uint64_t size = 1; // Scenarios that are consecutive in the source.
        while (scenarios.size() + size < count &&
               indices_[number + size] == indices_[number] + size) {
            ++size;
        }
        auto read = CD_TRY(source_.read(indices_[number], size));
        for (Scenario& scenario : read) {
            scenario.index = first + scenarios.size();
            scenarios.push_back(std::move(scenario));
        }
    }
    return scenarios;
}

} // namespace cd
