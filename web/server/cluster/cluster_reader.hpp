// The interface between the page of a cluster and the cluster: on the master, or over a connection.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/obb_tree.hpp"
#include "proto/messages/client_messages.hpp"
#include "web/server/page_source.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace cd {

/// Calls `take` with the results of scenarios [first, first + count) of one job in order, without
/// those that have none. An error of `take` ends the reading. Runs on a reading thread.
using RecordReader =
    std::function<Status(std::uint64_t first,
                         std::uint64_t count,
                         const std::function<Status(const ScenarioResult&)>& take)>;

/// Consecutive scenarios. The labels are empty unless the pose file has some.
struct LabelledScenarios {
    std::vector<Scenario> scenarios;
    PoseLabels labels;
};

using BodyTrees = std::array<std::shared_ptr<const ObbTree>, 2>;

class ClusterReader {
  public:
    ClusterReader() = default;
    ClusterReader(const ClusterReader&) = delete;
    ClusterReader& operator=(const ClusterReader&) = delete;
    virtual ~ClusterReader() = default;

    // ---- On the server's thread; these do not block ---------------------------------------------
    virtual void status(Take<ClusterStatus> take) = 0;
    /// Errors: NotFound; Refused for a job that is not done.
    virtual void map(const ContactMapQuery& query, Take<ContactMapAnswer> take) = 0;
    /// Errors: NotFound.
    [[nodiscard]] virtual Result<RecordReader> records(JobId job) = 0;
    /// Whether a scenario may be run now. Errors: TooLarge with the reason.
    [[nodiscard]] virtual Status may_run() = 0;

    // ---- On a reading thread; these block -------------------------------------------------------
    [[nodiscard]] virtual Result<JobDescription> description(JobId job) = 0;
    /// Reads scenarios [first, first + count), which exist.
    [[nodiscard]] virtual Result<LabelledScenarios>
    poses(JobId job, std::uint64_t first, std::uint64_t count) = 0;
    /// Loads or builds the trees of a job's bodies, in forms for exact searches and for the job's.
    [[nodiscard]] virtual Result<BodyTrees> trees(const Submit& submit) = 0;
    [[nodiscard]] virtual Result<std::shared_ptr<HttpBody>> mesh(const Sha256& mesh) = 0;
};

} // namespace cd
