// Answers the queries with which a client opens a job again: description, meshes, poses.
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

/// Answers one client's queries from what is on the disk, whether the job runs or has ended. All
/// members block for the disk. One thread at a time.
class JobQueries {
  public:
    /// Both outlive this.
    JobQueries(const Journal& journal, const GeometryStore& geometry)
        : journal_(journal), geometry_(geometry) {}

    /// The job as it was submitted. Errors: NotFound; Io.
    [[nodiscard]] Result<JobDescription> description(JobId job) const;
    /// The next bytes of a mesh. Errors: NotFound; BadInput for an offset behind the end; Io.
    [[nodiscard]] Result<MeshBytes> mesh(const MeshQuery& query) const;
    /// The poses of at least one scenario. Keeps the job's files open for the next query. Errors:
    /// NotFound; BadInput for scenarios that the job does not have; Io.
    [[nodiscard]] Result<JobPoses> poses(const PosesQuery& query);

  private:
    /// The files of the job that was asked for last.
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
