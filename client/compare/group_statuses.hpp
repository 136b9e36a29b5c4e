// The statuses of groups of contacts: computed against a baseline, or said by people.
#pragma once

#include "client/groups/group_sum.hpp"
#include "client/groups/groups_csv.hpp"
#include "client/spec/status_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// The status of a group (docs/report.md).
enum class GroupStatus : std::uint8_t {
    Unjudged,      ///< There is no baseline, and nobody has said anything.
    New,           ///< The baseline does not have it.
    Active,        ///< The baseline has it, too.
    Resolved,      ///< Only the baseline has it, and all its scenarios were tested now.
    NotComparable, ///< Only the baseline has it, and not all its scenarios were tested now.
    Reviewed,      ///< Said by people.
    Approved,
};

/// The statuses that a judged group can have, in the order of summaries.
inline constexpr std::array judged_statuses{GroupStatus::New,
                                            GroupStatus::Active,
                                            GroupStatus::Resolved,
                                            GroupStatus::NotComparable,
                                            GroupStatus::Reviewed,
                                            GroupStatus::Approved};

[[nodiscard]] std::string_view to_text(GroupStatus status);

struct JudgedGroup {
    Group group; ///< This run's; for groups that are gone, the baseline's.
    GroupStatus status = GroupStatus::Unjudged;
    std::string note = {}; ///< What people noted, and why their decision does not hold any more.
    bool is_in_baseline = false;
    std::uint64_t baseline_worst_pairs = 0; ///< 0 if the baseline does not have it.

    /// True if only the baseline has it.
    [[nodiscard]] bool is_gone() const {
        return status == GroupStatus::Resolved || status == GroupStatus::NotComparable;
    }
};

/// An earlier run that a run is judged against. A group is the same in both if its bodies have the
/// same positions in the job's list, and its parts the same names.
struct Baseline {
    std::vector<Group> groups;
    /// True if this run tested all scenarios that had a group. Called for groups that are gone.
    std::function<bool(const Group&)> is_resolved;
};

/// Judges groups by a baseline and by what people said. The last rule that matches a group counts.
/// A decision falls back to active (or new) if a scenario has more pairs than `pairs_max`, or, in a
/// rule without it, more than twice as many as any of the baseline.
class GroupStatuses {
  public:
    /// Judges the groups of a run. `baseline` is null without one; `bodies` are the names of the
    /// job's bodies.
    GroupStatuses(const std::vector<Group>& groups,
                  const Baseline* baseline,
                  const std::vector<StatusRule>& rules,
                  const std::vector<std::string>& bodies);

    /// Returns this run's groups in their order, then those that are gone.
    [[nodiscard]] const std::vector<JudgedGroup>& groups() const { return groups_; }
    /// Returns a line for each rule that matches no group.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    [[nodiscard]] std::uint64_t count(GroupStatus status) const;
    /// True for a group that the baseline does not have and that nobody approved.
    [[nodiscard]] static bool is_news(const JudgedGroup& group);
    [[nodiscard]] bool has_news() const;

  private:
    void add_baseline(const Baseline& baseline);
    void apply(const std::vector<StatusRule>& rules, const std::vector<std::string>& bodies);

    std::vector<JudgedGroup> groups_;
    std::vector<std::string> warnings_;
};

/// Returns the rows of groups.csv.
[[nodiscard]] std::vector<GroupRow> rows_of(const GroupStatuses& statuses);

} // namespace cd
