// Answers that a program holds, written into a results folder later.
#pragma once

#include "client/job/prepared_job.hpp"
#include "library/pose_sweep.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdcluster {

/// Returns the job of a question about two meshes, with poses of this form, without trees.
[[nodiscard]] cd::PreparedJob pair_job(const Mesh& a,
                                       const Mesh& b,
                                       std::unique_ptr<cd::PoseSource> poses,
                                       PoseForm form,
                                       const Query& query,
                                       const std::string& name = {});

/// Writes a job's answers into its output folder, as `cdctl run --out` does. Errors: BadInput if
/// the folder holds another run and `overwrite` is not set; Io.
void save_answers(cd::PreparedJob& job, const KeptAnswers& answers, bool overwrite);

/// The answers of a job, and what tells whether its files are still those that were read.
struct KeptRun {
    std::filesystem::path folder; ///< Where the run has kept its results; then nothing else is set.
    KeptAnswers answers;
    std::vector<cd::Sha256> meshes;
    std::optional<cd::Sha256> poses; ///< Of poses in a file.
};

/// Runs a job as `run` does, and keeps what `save_run` needs.
[[nodiscard]] Results run_and_keep(const Job& job, const RunOptions& options, KeptRun& kept);
/// Writes the answers of a job that has no folder into `folder`. Errors: as `save_answers`;
/// BadInput if a file of the job has changed.
void save_run(const Job& job,
              const KeptRun& kept,
              const std::filesystem::path& folder,
              bool overwrite);

/// Reads the inputs of a job that is submitted to a master. Errors: as `run`.
[[nodiscard]] cd::PreparedJob
prepare_to_submit(const Job& job, const std::filesystem::path& tree_cache, cd::ThreadPool& pool);

} // namespace cdcluster
