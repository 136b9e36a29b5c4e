#include "client/folder/run_groups.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace cd {

bool asks_for_groups(const Query& query) {
    return query.level >= Level::Pairs || (query.level == Level::Count && query.maps);
}

Status check_groups(const Query& query, const std::optional<ContactMap>& map) {
    if (!asks_for_groups(query)) {
        return bad_input("groups need level pairs or contacts, or level count with maps = true");
    }
    return query.level >= Level::Pairs || map
               ? Status(Done{})
               : bad_input("at level count the groups are in the contact map, which is missing");
}

Result<GroupSum> begin_groups(const Query& query,
                              std::vector<std::shared_ptr<const Mesh>> meshes,
                              const std::optional<ContactMap>& map,
                              PartKind kind) {
    CD_TRY(check_groups(query, map));
    GroupSum groups(std::move(meshes), kind);
    if (query.level < Level::Pairs) {
        CD_TRY(groups.add(map->parts));
    }
    return groups;
}

Result<GroupSum> groups_of(const RecordFile& records, GroupSum begun, const StopCheck& stop) {
    CD_TRY(records.for_each([&](const RecordView& record) {
        if (stop && stop()) {
            return Status(interrupted());
        }
        const ScenarioResult& result = record.result;
        if (std::max(result.body_a, result.body_b) >= begun.bodies()) {
            return Status(bad_input("the record of scenario " + std::to_string(result.index) +
                                    " names a body that the run does not have"));
        }
        begun.add(result);
        return Status(Done{});
    }));
    return begun;
}

} // namespace cd
