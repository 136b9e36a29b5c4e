// The groups of contacts of a finished run.
#pragma once

#include "client/groups/group_sum.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/query.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/record_file.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// True if a query asks for what groups are made of: lists of pairs, or at `level count` a contact
/// map with sums by part.
[[nodiscard]] bool asks_for_groups(const Query& query);

/// Checks that the groups of a run are known; `map` is its contact map. Errors: BadInput for a
/// query that does not ask for groups, and at `level count` without map.
[[nodiscard]] Status check_groups(const Query& query, const std::optional<ContactMap>& map);

/// Begins the sum of a run's groups, to which its results are to be added. At `level count` it has
/// the sums of `map`, the run's contact map. `meshes` holds the mesh of each body; `kind` must be
/// Named at `level count`. Errors: as `check_groups`; BadInput for parts of the map that the bodies
/// do not have.
[[nodiscard]] Result<GroupSum> begin_groups(const Query& query,
                                            std::vector<std::shared_ptr<const Mesh>> meshes,
                                            const std::optional<ContactMap>& map,
                                            PartKind kind);

/// Adds all records to the sum that `begin_groups` began. Errors: Io; BadInput for a record of a
/// body without mesh; Interrupted.
[[nodiscard]] Result<GroupSum>
groups_of(const RecordFile& records, GroupSum begun, const StopCheck& stop);

} // namespace cd
