// The groups of contacts of a finished run.
#pragma once

#include "client/folder/opened_run.hpp"
#include "client/groups/group_sum.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/result/record_file.hpp"

#include <memory>
#include <vector>

namespace cd {

/// Sums the groups of all records; `meshes` holds the mesh of each body. Below `level pairs` there
/// are no groups. Errors: Io; BadInput for a record of a body without mesh; Interrupted.
[[nodiscard]] Result<GroupSum> groups_of(const RecordFile& records,
                                         std::vector<std::shared_ptr<const Mesh>> meshes,
                                         const StopCheck& stop);

/// Sums the groups of a run. Errors: also those of `OpenedRun::mesh`.
[[nodiscard]] Result<GroupSum> groups_of(const OpenedRun& run, const StopCheck& stop);

} // namespace cd
