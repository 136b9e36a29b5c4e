// The interface between the page of a cluster and the cluster: on the master, or over a connection.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/labelled_scenarios.hpp"
#include "common/job/result/result.hpp"
#include "common/job/scenario.hpp"
#include "common/job/trees_by_body.hpp"
#include "proto/messages/client_messages.hpp"
#include "web/server/page_source.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace cd {

/// Gets a result and its place: its scenario, or in a sample its place there. An error ends the
/// reading.
using TakeRecord = std::function<Status(std::uint64_t place, const ScenarioResult&)>;
/// Calls `take` with the results of the chosen scenarios of one job in order, without those that
/// have none. Runs on a reading thread.
using RecordReader = std::function<Status(const ScenarioChoice& choice, const TakeRecord& take)>;

/// Returns the query of a choice's results, or of its poses.
template <class Query>
[[nodiscard]] Query query_of(JobId job, const ScenarioChoice& choice) {
    return {job, choice.sample == 0 ? choice.first : 0, choice.size(), choice.sample};
}

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
    /// `scenarios` is the job's number of them. Errors: NotFound.
    [[nodiscard]] virtual Result<RecordReader> records(JobId job, std::uint64_t scenarios) = 0;
    /// Whether a scenario may be run now. Errors: TooLarge with the reason.
    [[nodiscard]] virtual Status may_run() = 0;

    // ---- On a reading thread; these block -------------------------------------------------------
    [[nodiscard]] virtual Result<JobDescription> description(JobId job) = 0;
    /// Reads the chosen scenarios, which exist.
    [[nodiscard]] virtual Result<LabelledScenarios> poses(JobId job,
                                                          const ScenarioChoice& choice) = 0;
    /// Loads or builds the trees of a job's bodies, in forms for exact searches and for the job's.
    [[nodiscard]] virtual Result<BodyTrees> trees(const Submit& submit) = 0;
    [[nodiscard]] virtual Result<std::shared_ptr<HttpBody>> mesh(const Sha256& mesh) = 0;
};

} // namespace cd
