// Reads the master's jobs for the page.
#pragma once

#include "master/coordinator/coordinator.hpp"
#include "master/jobs/job_queries.hpp"
#include "web/server/cluster/cluster_reader.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace cd {

/// Its disk sizes are at most a few seconds old.
class CoordinatorReader final : public ClusterReader {
  public:
    /// The coordinator, with its geometry store, outlives the reader.
    explicit CoordinatorReader(Coordinator& coordinator);

    void status(Take<ClusterStatus> take) override;
    void map(const ContactMapQuery& query, Take<ContactMapAnswer> take) override;
    [[nodiscard]] Result<RecordReader> records(JobId job, std::uint64_t scenarios) override;
    [[nodiscard]] Status may_run() override;
    [[nodiscard]] Result<JobDescription> description(JobId job) override;
    [[nodiscard]] Result<LabelledScenarios> poses(JobId job, const ScenarioChoice& choice) override;
    [[nodiscard]] Result<BodyTrees> trees(const Submit& submit) override;
    [[nodiscard]] Result<std::shared_ptr<HttpBody>> mesh(const Sha256& mesh) override;
    /// Bytes of the file system that holds the state; 0 before the first measurement.
    [[nodiscard]] std::uint64_t disk() const;

  private:
    /// The sizes on the disk, which a pool measures.
    struct Sizes;
    void measure();

    Coordinator& coordinator_;
    JobQueries queries_;
    std::shared_ptr<Sizes> sizes_;
};

/// Returns the reason why the master or one of its jobs is paused; empty if none is.
[[nodiscard]] std::string reason_of_pause(const Coordinator& coordinator);

} // namespace cd
