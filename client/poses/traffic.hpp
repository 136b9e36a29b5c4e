// Where the vehicles of a traffic simulation are at each step.
#pragma once

#include "common/geometry/pose.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A vehicle of a simulation.
struct TrafficVehicle {
    std::string id;
    std::string body;       ///< The entry of [bodies] that its type has.
    std::uint64_t line = 0; ///< The line of the file that names it first.
};

/// A vehicle at a step.
struct TrafficRow {
    std::uint32_t vehicle = 0; ///< Its index in `RoadTraffic::vehicles`.
    Quaternion rotation;
    Vec3 position; ///< In the job's unit.
};

/// All vehicles of a simulation. Memory: some 64 bytes for each vehicle at each step that has it.
struct RoadTraffic {
    std::string name = {};                     ///< The file's name.
    std::vector<TrafficVehicle> vehicles = {}; ///< In the order of their first rows.
    std::vector<double> times = {};            ///< The time of each step in seconds; they rise.
    std::vector<TrafficRow> rows = {};         ///< Those of each step together.
    std::vector<std::size_t> ends = {};        ///< Where the rows of each step end.
    std::vector<std::string> warnings = {};    ///< A sentence each, naming the file.

    /// Returns the rows of a step, which exists: each vehicle at most once.
    [[nodiscard]] std::span<const TrafficRow> rows_of(std::uint64_t step) const {
        const std::size_t begin = step == 0 ? 0 : ends[step - 1];
        return std::span(rows).subspan(begin, ends[step] - begin);
    }
};

} // namespace cd
