// Gathers the vehicles of a traffic simulation from the texts of a file.
#pragma once

#include "client/poses/traffic.hpp"
#include "client/spec/fcd_spec.hpp"
#include "common/core/result.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// The attributes of a vehicle that are read, by their names in SUMO's FCD.
inline constexpr std::array<std::string_view, 7> fcd_attributes{
    "id", "type", "x", "y", "angle", "z", "slope"};
/// So many of `fcd_attributes` are needed, the first ones.
inline constexpr std::size_t fcd_attributes_needed = 5;

/// The texts of `fcd_attributes`; nothing for one that the file does not give.
using FcdTexts = std::array<std::optional<std::string_view>, fcd_attributes.size()>;

/// Takes the steps of a file and the vehicles of each step, in the order of the file.
///
/// SUMO's x and y are the middle of the front bumper, in metres, and become the place of the body's
/// origin. Its angle is clockwise from north, so the yaw is 90 - angle degrees. A slope in degrees
/// lifts the front. All are computed once, in double.
class TrafficBuilder {
  public:
    /// `spec` has to outlive the builder.
    explicit TrafficBuilder(const FcdSpec& spec) : spec_(spec) {}

    /// Begins a step. Errors: BadInput naming the line, for a time that is no number of seconds, or
    /// that is not later than the step before.
    [[nodiscard]] Status begin_step(std::string_view time, std::uint64_t line);
    /// Adds a vehicle to the current step, which exists. Errors: BadInput naming the line, for an
    /// attribute that is missing or no number, an id that no body may have, a vehicle that the step
    /// has already or that changes its body, and above `limits::bodies_max` vehicles.
    [[nodiscard]] Status add(const FcdTexts& texts, std::uint64_t line);
    /// Returns the time of the current step; nothing before the first.
    [[nodiscard]] std::optional<double> time() const;

    /// Returns all vehicles. A warning names types in the job that no vehicle has. Errors: BadInput
    /// for a file without steps, and naming the types that the job does not name, unless it leaves
    /// them out.
    [[nodiscard]] Result<RoadTraffic> finish();

  private:
    [[nodiscard]] Result<std::uint32_t>
    vehicle_of(std::string_view id, const std::string& body, std::uint64_t line);
    [[nodiscard]] Status check_types() const;
    void note_other_type(std::string_view type, std::uint64_t line);

    const FcdSpec& spec_;
    RoadTraffic made_;
    std::map<std::string, std::uint32_t, std::less<>> numbers_; ///< The index of each vehicle's id.
    std::vector<std::size_t> last_steps_; ///< The last step of each vehicle, counted from 1.
    std::map<std::string, std::uint64_t, std::less<>> seen_types_; ///< With the first line of each.
    /// Types that the job does not name, with the first line of each; not all if there are many.
    std::map<std::string, std::uint64_t, std::less<>> other_types_;
};

} // namespace cd
