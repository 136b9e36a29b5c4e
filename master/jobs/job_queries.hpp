// Answers the queries with which a client reopens a job: description, meshes, poses.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/labelled_scenarios.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/journal/journal.hpp"
#include "proto/messages/client_messages.hpp"

namespace cd {

/// Answers queries from the disk, for running and ended jobs. Keeps no file open between queries: a
/// removed job would occupy the disk until its files are closed. All members may block on the disk.
/// Any thread.
class JobQueries {
  public:
    /// Both references must outlive this object.
    JobQueries(const Journal& journal, const GeometryStore& geometry)
        : journal_(journal), geometry_(geometry) {}

    /// Returns the job as submitted. Errors: NotFound; Io.
    [[nodiscard]] Result<JobDescription> description(JobId job) const;
    /// Returns the next bytes of a mesh. Errors: NotFound; BadInput for an offset past the end; Io.
    [[nodiscard]] Result<MeshBytes> mesh(const MeshQuery& query) const;
    /// Returns the poses of the first queried scenarios, as many as one message may hold.
    /// Errors: NotFound; BadInput for scenarios that the job lacks; Io.
    [[nodiscard]] Result<JobPoses> poses(const PosesQuery& query) const;
    /// Returns all queried scenarios. Errors: as `poses`.
    [[nodiscard]] Result<LabelledScenarios> scenarios(const PosesQuery& query) const;

  private:
    const Journal& journal_;
    const GeometryStore& geometry_;
};

} // namespace cd
