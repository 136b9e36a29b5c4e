// A job fetched from a master with its meshes and poses.
#pragma once

#include "client/cli/cli.hpp"
#include "client/commands/remote_session.hpp"
#include "client/folder/folder_run.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/mesh_cache.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// A job on a master, prepared like the job that `run --master` has, to fetch its results.
class FetchedJob {
  public:
    /// Fetches the description and the meshes that are not cached; poses are fetched on demand.
    /// `text` is a job id as users write it, `tree_cache` as for `MeshCache`. Errors: those of the
    /// connection; NotFound.
    [[nodiscard]] static Result<FetchedJob> open(const MasterOptions& master,
                                                 const std::string& text,
                                                 const std::filesystem::path& tree_cache);

    [[nodiscard]] PreparedJob& prepared() { return *prepared_; }
    [[nodiscard]] const KnownJob& known() const { return known_; }
    /// `coverage_text` of the results fetched so far; empty for a completed job.
    [[nodiscard]] std::string coverage() const { return coverage_text(known_.status, fetched_); }

    /// Writes the results to stdout in the format `output`. Errors: those of the connection and of
    /// writing.
    [[nodiscard]] Result<RunReport> print(const std::string& output);
    /// Writes the results into the output folder of the prepared job. Errors: those of `FolderRun`
    /// and of the connection.
    [[nodiscard]] Result<RunReport> write(FolderRunOptions options, const std::string& output);

  private:
    FetchedJob(std::unique_ptr<Connection> connection, KnownJob known)
        : connection_(std::move(connection)), known_(std::move(known)) {}

    [[nodiscard]] Status prepare(const MeshCache& meshes);
    [[nodiscard]] Result<RunReport> make_report();
    [[nodiscard]] Result<RunReport> write_into(FolderRun& run, const std::string& output);
    [[nodiscard]] Status fetch_labels();

    std::unique_ptr<Connection> connection_;
    KnownJob known_;
    std::unique_ptr<PreparedJob> prepared_;
    LabelColumns labels_;       ///< The job's label columns.
    std::uint64_t fetched_ = 0; ///< Results fetched so far.
};

/// The report of a job on a master, with the contact map if the master summed one.
[[nodiscard]] Result<RunReport>
fetched_report(Connection& connection, const Query& query, const JobStatus& status);

} // namespace cd
