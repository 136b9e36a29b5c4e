// A job of a master, fetched back with its meshes and poses.
#pragma once

#include "client/cli.hpp"
#include "client/commands/remote_session.hpp"
#include "client/folder/folder_run.hpp"
#include "client/mesh_cache.hpp"
#include "client/prepared_job.hpp"
#include "client/report.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace cd {

/// What `run --master` has at hand when its job has ended, for a job that somebody submitted.
class FetchedJob {
  public:
    /// Fetches the description and the meshes that are not kept beside the trees; poses come as
    /// they are read. `text` is a job's id as users write it, `tree_cache` as for `MeshCache`.
    /// Errors: those of the connection; NotFound.
    [[nodiscard]] static Result<FetchedJob> open(const MasterOptions& master,
                                                 const std::string& text,
                                                 const std::filesystem::path& tree_cache);

    [[nodiscard]] PreparedJob& prepared() { return *prepared_; }
    [[nodiscard]] const KnownJob& known() const { return known_; }
    /// How much of the job has an answer; empty where all has.
    [[nodiscard]] std::string coverage() const { return coverage_text(known_.status, fetched_); }

    /// Writes the results to stdout. Errors: those of the connection and of writing.
    [[nodiscard]] Result<RunReport> print(const std::string& output);
    /// Writes them into the folder that the prepared job names. Errors: those of `FolderRun` and of
    /// the connection.
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
    LabelColumns labels_;       ///< Of the poses.
    std::uint64_t fetched_ = 0; ///< Results.
};

/// What a report says of a job on a master, with the map where that summed one.
[[nodiscard]] Result<RunReport>
fetched_report(Connection& connection, const Query& query, const JobStatus& status);

} // namespace cd
