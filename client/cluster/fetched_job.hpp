// A job fetched from a master with its meshes, poses and results.
#pragma once

#include "client/cluster/job_on_master.hpp"
#include "client/folder/folder_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/local/done_scenario.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// Takes the next result of a job. An error that it returns ends the fetch.
using TakeResult = std::function<Status(const DoneScenario&)>;

/// A job on a master, prepared as for `run --master`, in order to fetch its results.
class FetchedJob {
  public:
    /// Fetches the job's description and the meshes that are not cached; poses are fetched on
    /// demand. `tree_cache` is as for `MeshCache`. Errors: the connection's; NotFound.
    [[nodiscard]] static Result<FetchedJob> open(ConnectedJob connected,
                                                 const std::filesystem::path& tree_cache);

    [[nodiscard]] PreparedJob& prepared() { return *prepared_; }
    [[nodiscard]] const JobStatus& status() const { return job_.status; }

    /// Passes all existing results to `take`. Returns a report. Errors: as `fetch_results`.
    [[nodiscard]] Result<RunReport> fetch(const TakeResult& take);
    /// Writes the results to stdout in the format `output`. Errors: the connection's; from
    /// writing.
    [[nodiscard]] Result<RunReport> print(const std::string& output);
    /// Writes the results into the output folder of the prepared job. Errors: as `FolderRun`; the
    /// connection's.
    [[nodiscard]] Result<RunReport> write(FolderRunOptions options, const std::string& output);

  private:
    explicit FetchedJob(ConnectedJob job) : job_(std::move(job)) {}

    [[nodiscard]] Status prepare(const std::filesystem::path& tree_cache);
    [[nodiscard]] Status fetch_labels();
    [[nodiscard]] Result<RunReport> fetch_into(FolderRun& run, const std::string& output);

    ConnectedJob job_;
    std::unique_ptr<PreparedJob> prepared_;
    LabelColumns labels_; ///< Which labels the job's scenarios have.
};

/// Makes a report of a job that has ended. `query` is the query of the job.
[[nodiscard]] RunReport report_of(const JobStatus& job, const Query& query);

/// Passes all existing results of a job to `take`. Returns a report, with the contact map if the
/// master summed one. Errors: the connection's; from `take`; BadFrame if the results do not match
/// the digest that the master states for a completed job.
[[nodiscard]] Result<RunReport> fetch_results(Connection& connection,
                                              const PreparedJob& job,
                                              const JobStatus& status,
                                              const TakeResult& take);

} // namespace cd
