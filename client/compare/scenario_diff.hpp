// Which scenarios have other results in a later run.
#pragma once

#include "client/compare/paired_results.hpp"
#include "client/formats/output_file.hpp"
#include "common/core/result.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// What is compared of a scenario's two results.
struct ScenarioDiffOptions {
    /// Also the listed pairs of triangles: for equal meshes and queries. Results of two levels are
    /// compared without their pairs in any case.
    bool compares_pairs = false;
    std::vector<std::string> bodies; ///< Names of the later run's bodies.
    bool has_near = false;           ///< A run has a clearance.
    bool has_distance = false;       ///< A run asks for the distance.
};

/// The kinds of outcome of a scenario: the classes by their number, then "none".
inline constexpr std::size_t outcome_kinds = 9;
/// Returns the name of a class, or "none" for a missing result.
[[nodiscard]] std::string_view outcome_name(std::size_t outcome);

/// Counts of scenarios of two runs.
struct ScenarioCounts {
    std::uint64_t in_both = 0;
    std::uint64_t only_earlier = 0;
    std::uint64_t only_later = 0;
    std::uint64_t apart = 0;      ///< In both, but in one only by the boxes of a scene's bodies.
    std::uint64_t comparable = 0; ///< In both, with a class other than failed and undecided.
    std::uint64_t changed = 0;    ///< In both, with another result.
    /// Scenarios in both, by outcome in the earlier run, then in the later run.
    std::array<std::array<std::uint64_t, outcome_kinds>, outcome_kinds> outcomes{};
};

/// Counts changed scenarios, and writes a CSV row for each: scenario, scenario_old, body_a, body_b,
/// class_old, class, count_old, count, change (class, count, distance, bracket, near, hits or
/// pairs: the first that differs). A scenario that a run has by boxes alone has no number there.
/// Before the change it has, with a clearance, near_old and near; with the question of the distance
/// distance_old and distance, empty if there is none. A count is empty at level any, and for a
/// missing result. Classes of level any equal the classes of other levels that they stand for. If
/// only one of the results has a clearance, its class near equals separate, and near pairs are not
/// compared. Distances are compared by their bits, if both results answer for them. Brackets of
/// motions are compared if both searches end at contact or with the motion, or both at the way out;
/// motions that are free throughout have none. Hits of lines are compared by line, depth and flags,
/// if both results list them all.
class ScenarioDiff {
  public:
    /// `csv` may be nothing.
    ScenarioDiff(std::optional<OutputFile> csv, ScenarioDiffOptions options);

    /// Counts a scenario. Errors: Io.
    [[nodiscard]] Status add(const PairedResult& pair);
    /// Completes the file. Errors: Io.
    [[nodiscard]] Status finish();

    [[nodiscard]] const ScenarioCounts& counts() const { return counts_; }

  private:
    [[nodiscard]] std::string_view change_of(const PairedResult& pair) const;
    [[nodiscard]] Status write(const PairedResult& pair, std::string_view change);
    [[nodiscard]] std::string header_once();

    std::optional<OutputFile> csv_;
    ScenarioDiffOptions options_;
    ScenarioCounts counts_;
    bool has_header_ = false;
};

} // namespace cd
