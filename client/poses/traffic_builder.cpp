#include "client/poses/traffic_builder.hpp"

#include "client/import/text/text_reader.hpp"
#include "client/poses/csv_columns.hpp"
#include "client/spec/scene_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cmath>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t other_types_max = 20;

/// The numbers of a vehicle, by the order of `fcd_attributes` after id and type.
struct VehicleNumbers {
    double x = 0;
    double y = 0;
    double angle = 0;
    std::optional<double> z;
    double slope = 0;
};

/// Reads an attribute; nothing if it is missing. Errors: BadInput for one that is no finite number.
Result<std::optional<double>>
number_of(const FcdTexts& texts, std::size_t attribute, std::uint64_t line) {
    if (!texts[attribute]) {
        return std::optional<double>();
    }
    const auto number = to_number(*texts[attribute]);
    if (!number || !std::isfinite(*number)) {
        return error_in_line(line,
                             std::string(fcd_attributes[attribute]) + " is " +
                                 in_quotes(*texts[attribute]) + ", not a number");
    }
    return number;
}

Result<VehicleNumbers> numbers_of(const FcdTexts& texts, std::uint64_t line) {
    VehicleNumbers numbers;
    numbers.x = CD_TRY(number_of(texts, 2, line)).value_or(0);
    numbers.y = CD_TRY(number_of(texts, 3, line)).value_or(0);
    numbers.angle = CD_TRY(number_of(texts, 4, line)).value_or(0);
    numbers.z = CD_TRY(number_of(texts, 5, line));
    numbers.slope = CD_TRY(number_of(texts, 6, line)).value_or(0);
    return numbers;
}

Status check_needed(const FcdTexts& texts, std::uint64_t line) {
    for (std::size_t i = 0; i < fcd_attributes_needed; ++i) {
        if (!texts[i]) {
            return error_in_line(line,
                                 "a vehicle without " + std::string(fcd_attributes[i]) +
                                     "; let SUMO write the attributes id, type, x, y and angle");
        }
    }
    return Done{};
}

} // namespace

std::optional<double> TrafficBuilder::time() const {
    return made_.times.empty() ? std::nullopt : std::optional(made_.times.back());
}

Status TrafficBuilder::begin_step(std::string_view time, std::uint64_t line) {
    const auto seconds = to_number(time);
    if (!seconds || !std::isfinite(*seconds)) {
        return error_in_line(line,
                             "time is " + in_quotes(time) +
                                 ", not a number of seconds; run sumo with "
                                 "--human-readable-time false");
    }
    if (!made_.times.empty() && !(made_.times.back() < *seconds)) {
        return error_in_line(line,
                             "time " + exact_text(*seconds) + " is not later than " +
                                 exact_text(made_.times.back()) + " of the step before");
    }
    made_.times.push_back(*seconds);
    made_.ends.push_back(made_.rows.size());
    return Done{};
}

Status TrafficBuilder::add(const FcdTexts& texts, std::uint64_t line) {
    CD_TRY(check_needed(texts, line));
    const auto type = spec_.types.find(std::string(*texts[1]));
    if (type == spec_.types.end()) {
        note_other_type(*texts[1], line);
        return Done{};
    }
    seen_types_.try_emplace(type->first, line);
    const auto vehicle = CD_TRY(vehicle_of(*texts[0], type->second, line));
    if (last_steps_[vehicle] == made_.times.size()) {
        return error_in_line(line,
                             "vehicle " + in_quotes(*texts[0]) + " is twice in the step of time " +
                                 exact_text(made_.times.back()));
    }
    last_steps_[vehicle] = made_.times.size();
    const auto numbers = CD_TRY(numbers_of(texts, line));
    const double factor = spec_.length_factor;
    const Vec3 position(
        factor * numbers.x, factor * numbers.y, numbers.z ? factor * *numbers.z : spec_.z);
    if (!position.allFinite()) {
        return error_in_line(line, "a position is too large in the job's unit");
    }
    made_.rows.push_back(
        {vehicle, quaternion_from_euler(0, -numbers.slope, 90 - numbers.angle), position});
    made_.ends.back() = made_.rows.size();
    return Done{};
}

Result<std::uint32_t>
TrafficBuilder::vehicle_of(std::string_view id, const std::string& body, std::uint64_t line) {
    if (const auto known = numbers_.find(id); known != numbers_.end()) {
        const TrafficVehicle& vehicle = made_.vehicles[known->second];
        if (vehicle.body != body) {
            return error_in_line(line,
                                 "vehicle " + in_quotes(id) + " is of body \"" + body +
                                     "\" here and of \"" + vehicle.body + "\" in line " +
                                     std::to_string(vehicle.line));
        }
        return known->second;
    }
    if (const auto problem = problem_of_body_name(id)) {
        return error_in_line(line, "id is " + in_quotes(id) + ": " + *problem);
    }
    if (made_.vehicles.size() == limits::bodies_max) {
        return error_in_line(line,
                             "has vehicle number " + std::to_string(limits::bodies_max + 1) +
                                 "; a job has at most " + grouped(limits::bodies_max) + " bodies");
    }
    const auto number = static_cast<std::uint32_t>(made_.vehicles.size());
    numbers_.emplace(id, number);
    made_.vehicles.push_back({std::string(id), body, line});
    last_steps_.push_back(0);
    return number;
}

void TrafficBuilder::note_other_type(std::string_view type, std::uint64_t line) {
    if (other_types_.size() < other_types_max && other_types_.find(type) == other_types_.end()) {
        other_types_.emplace(type, line);
    }
}

Status TrafficBuilder::check_types() const {
    if (other_types_.empty() || spec_.skips_other_types) {
        return Done{};
    }
    std::string names;
    for (const auto& [type, line] : other_types_) {
        names +=
            (names.empty() ? "" : ", ") + in_quotes(type) + " (line " + std::to_string(line) + ")";
    }
    return bad_input("[poses] fcd types names no body for the vehicle types " + names +
                     "; name one for each, or leave their vehicles out with other_types = "
                     "\"skip\"");
}

Result<RoadTraffic> TrafficBuilder::finish() {
    if (made_.times.empty()) {
        return bad_input("has no steps; let SUMO run for some seconds");
    }
    CD_TRY(check_types());
    for (const auto& [type, body] : spec_.types) {
        if (seen_types_.find(type) == seen_types_.end()) {
            made_.warnings.push_back("[poses] fcd types names \"" + type +
                                     "\", and no vehicle is of that type");
        }
    }
    return std::move(made_);
}

} // namespace cd
