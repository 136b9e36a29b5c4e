// The differences of two runs, as text and as JSON.
#pragma once

#include "client/compare/group_diff.hpp"
#include "client/compare/input_changes.hpp"
#include "client/compare/scenario_diff.hpp"
#include "client/compare/scenario_match.hpp"
#include "client/compare/triangle_diff.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cd {

/// How the triangles of a body with an equal mesh differ.
struct BodyTriangles {
    std::string body; ///< The body's name in the later run.
    TriangleCounts counts;
};

/// What `cdctl diff` reports.
struct DiffReport {
    InputChanges inputs;
    MatchedBy matched_by = MatchedBy::Index;
    ScenarioCounts scenarios;
    std::vector<std::string> bodies; ///< Names of the bodies in the later run.
    bool has_groups = false;         ///< The groups of both runs are known.
    bool has_near = false;           ///< A run has a clearance.
    bool lists_are_cut = false;      ///< `limit_pairs` may have cut lists of pairs.
    bool has_lasting_names = true;   ///< As in `GroupDiff`.
    bool are_sums_comparable = true; ///< As in `GroupDiff`.
    std::uint64_t left_out = 0;      ///< As in `GroupDiff`.
    std::vector<ChangedGroup> groups{};
    std::vector<BodyTriangles> triangles{};

    /// True if a scenario has another result, or a group is neither unchanged nor not comparable.
    [[nodiscard]] bool has_changes() const;
    [[nodiscard]] std::uint64_t count(GroupState state) const;
};

/// Returns the report in lines with newlines. The first says what differs in the inputs.
[[nodiscard]] std::string diff_text(const DiffReport& report);
/// Returns the report, with all groups, as a JSON document.
[[nodiscard]] std::string diff_json(const DiffReport& report);

} // namespace cd
