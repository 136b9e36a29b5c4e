// The file groups.csv.
#pragma once

#include "client/groups/group_sum.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cd {

/// A row of groups.csv.
struct GroupRow {
    Group group;
    std::string status = {}; ///< Its status (docs/report.md); empty without baseline and statuses.
    std::string note = {};
    bool is_gone = false; ///< Only the baseline has the group, so it has no share of this run.
};

/// Returns rows without statuses.
[[nodiscard]] std::vector<GroupRow> rows_of(const GroupSum& sum);

/// What groups.csv says about the run of the groups.
struct GroupsOrigin {
    std::vector<std::string> bodies; ///< The names of the job's bodies.
    std::uint64_t tested = 0;        ///< Number of scenarios that were tested.
    std::uint64_t limit_pairs = 0;   ///< Maximum number of pairs in a result; 0: all.
    std::uint64_t left_out = 0;      ///< As `GroupSum::left_out`.
    bool has_near = false;           ///< The run has a clearance.
};

/// Writes groups.csv (docs/report.md). Shares are empty if results do not list all pairs. Pairs in
/// no group make up a last row with the parts `*`. With a clearance the columns near and worst_near
/// count near pairs. Errors: Io naming the file.
[[nodiscard]] Status write_groups_csv(const std::filesystem::path& path,
                                      const std::vector<GroupRow>& rows,
                                      const GroupsOrigin& origin);

} // namespace cd
