#include "client/groups/groups_csv.hpp"

#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace cd {

namespace {

std::string header_of(const GroupsOrigin& origin) {
    return std::string("body_a,part_a,body_b,part_b,class,scenarios,share,pairs,") +
           (origin.has_near ? "near," : "") + "worst,worst_pairs," +
           (origin.has_near ? "worst_near," : "") +
           "regions_a,regions_b,episodes,first,last,status,note\n";
}

/// Returns a field and its comma; nothing if the run has no clearance.
std::string near_field(const GroupsOrigin& origin, std::uint64_t count) {
    return origin.has_near ? std::to_string(count) + "," : "";
}

Status add_row(RowFile& file, const GroupRow& row, const GroupsOrigin& origin) {
    const Group& group = row.group;
    const double share = static_cast<double>(group.scenarios) /
                         static_cast<double>(std::max<std::uint64_t>(1, origin.tested));
    const std::string& body_a = origin.bodies[group.body_a];
    const std::string& body_b = origin.bodies[group.body_b];
    CD_TRY(file.add(csv_field(body_a), ",", csv_field(group.part_a), ","));
    CD_TRY(file.add(csv_field(body_b), ",", csv_field(group.part_b), ","));
    CD_TRY(file.add(to_text(group.kind), ",", group.scenarios, ","));
    const bool has_share = origin.limit_pairs == 0 && !row.is_gone;
    CD_TRY(file.add(has_share ? exact_text(share) : "", ",", group.pairs, ","));
    CD_TRY(file.add(near_field(origin, group.near.pairs)));
    CD_TRY(file.add(group.worst, ",", group.worst_pairs, ","));
    CD_TRY(file.add(near_field(origin, group.near.worst_pairs)));
    CD_TRY(file.add(group.regions[0], ",", group.regions[1], ",", group.episodes.count, ","));
    CD_TRY(file.add(group.episodes.first.front().first, ",", group.episodes.last, ","));
    return file.add(csv_field(row.status), ",", csv_field(row.note), "\n");
}

} // namespace

std::vector<GroupRow> rows_of(const GroupSum& sum) {
    std::vector<GroupRow> rows;
    for (Group& group : sum.groups()) {
        rows.push_back({std::move(group)});
    }
    return rows;
}

Status write_groups_csv(const std::filesystem::path& path,
                        const std::vector<GroupRow>& rows,
                        const GroupsOrigin& origin) {
    auto file = CD_TRY(RowFile::create(path, header_of(origin)));
    for (const GroupRow& row : rows) {
        CD_TRY(add_row(file, row, origin));
    }
    if (origin.left_out != 0) {
        const std::string_view rest = origin.has_near ? ",,,,,,,,,,,\n" : ",,,,,,,,,\n";
        CD_TRY(file.add(",*,,*,,,,", origin.left_out, rest));
    }
    return file.commit();
}

} // namespace cd
