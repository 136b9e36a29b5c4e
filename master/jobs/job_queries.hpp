// Answers the queries with which a client reopens a job: description, meshes, poses.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/jobs/label_spool.hpp"
#include "master/journal/journal.hpp"
#include "proto/messages/client_messages.hpp"

#include <memory>
#include <optional>

namespace cd {

/// Answers one client's queries from the disk, for running and ended jobs. All members block for
/// the disk. One thread at a time.
class JobQueries {
  public:
    /// Both must outlive this.
    JobQueries(const Journal& journal, const GeometryStore& geometry)
        : journal_(journal), geometry_(geometry) {}

    /// Returns the job as submitted. Errors: NotFound; Io.
    [[nodiscard]] Result<JobDescription> description(JobId job) const;
    /// Returns the next bytes of a mesh. Errors: NotFound; BadInput for an offset past the end; Io.
    [[nodiscard]] Result<MeshBytes> mesh(const MeshQuery& query) const;
    /// Returns the poses of at least one scenario. Keeps the job's files open for the next query.
    /// Errors: NotFound; BadInput for scenarios that the job lacks; Io.
    [[nodiscard]] Result<JobPoses> poses(const PosesQuery& query);

  private:
    /// Open files of the job last queried.
    struct OpenJob {
        JobId job;
        std::shared_ptr<PoseSource> poses;
        std::unique_ptr<LabelSpool> labels; ///< Null for a job without labels.
    };
    [[nodiscard]] Status open(JobId job);

    const Journal& journal_;
    const GeometryStore& geometry_;
    std::optional<OpenJob> open_;
};

} // namespace cd
