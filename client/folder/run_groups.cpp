#include "client/folder/run_groups.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace cd {

Result<GroupSum> groups_of(const RecordFile& records,
                           std::vector<std::shared_ptr<const Mesh>> meshes,
                           const StopCheck& stop) {
    const std::size_t bodies = meshes.size();
    GroupSum sum(std::move(meshes));
    CD_TRY(records.for_each([&](const KeptRecord& record) {
        if (stop && stop()) {
            return Status(interrupted());
        }
        const ScenarioResult& result = record.result;
        if (std::max(result.body_a, result.body_b) >= bodies) {
            return Status(bad_input("the record of scenario " + std::to_string(result.index) +
                                    " names a body that the run does not have"));
        }
        sum.add(result);
        return Status(Done{});
    }));
    return sum;
}

Result<GroupSum> groups_of(const OpenedRun& run, const StopCheck& stop) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (std::size_t i = 0; i < run.manifest().bodies.size(); ++i) {
        meshes.push_back(CD_TRY(run.mesh(i)));
    }
    return groups_of(run.records(), std::move(meshes), stop);
}

} // namespace cd
