#include "client/commands/compare/earlier_run.hpp"

#include "client/base/interrupt.hpp"
#include "client/compare/input_changes.hpp"
#include "client/folder/folder_run.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <cstdio>

namespace cd {

namespace {

/// Returns the inputs of an earlier run of a job: its poses, and the job's meshes, which are equal.
Result<JobInputs> inputs_like(const PreparedJob& job, const OpenedRun& earlier) {
    CD_TRY(check_reusable(earlier.manifest(), job));
    JobInputs inputs;
    inputs.meshes = job.meshes;
    inputs.poses = CD_TRY(earlier.kept_poses());
    inputs.ignored = job.query.ignored;
    inputs.names = job.names;
    if (inputs.poses) {
        inputs.scene = CD_TRY(earlier.scene());
    }
    return inputs;
}

} // namespace

Result<EarlierRun> EarlierRun::open(const std::string& argument,
                                    const MasterOptions& master,
                                    const std::string& tree_cache,
                                    const PreparedJob& job,
                                    ThreadPool& pool) {
    if (!is_folder(argument) && master.address.empty()) {
        return bad_input("there is no folder '" + argument +
                         "' to reuse; a job of a master needs --master");
    }
    auto opened =
        CD_TRY(open_run_at_hand(argument, master, tree_cache, {}, pool, [&](const OpenedRun& run) {
            return inputs_like(job, run);
        }));
    const RunManifest& manifest = opened.run.manifest();
    ManifestReuse named{is_folder(argument) ? absolute_path(argument) : manifest.where.job,
                        manifest.outcome.digest};
    return EarlierRun(std::move(opened), std::move(named));
}

Result<ReusedResults> EarlierRun::results_for(const PreparedJob& job, bool quiet) {
    auto reused = CD_TRY(ReusedResults::find(opened_.run.records(),
                                             *opened_.job.poses,
                                             *job.poses,
                                             job.query,
                                             &InterruptGuard::has_come));
    if (!quiet) {
        std::fprintf(stderr,
                     "%s of %s are those of %s\n",
                     grouped(reused.count()).c_str(),
                     counted(reused.scenarios(), "result").c_str(),
                     named_.run.c_str());
    }
    return reused;
}

} // namespace cd
