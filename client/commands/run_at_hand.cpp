#include "client/commands/run_at_hand.hpp"

#include "client/base/interrupt.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/run_command.hpp"
#include "common/core/files/disk_file.hpp"

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

namespace cd {

namespace {

Status fetch_into(const std::filesystem::path& dir,
                  const std::string& id,
                  const MasterOptions& master,
                  const std::filesystem::path& tree_cache) {
    auto job = FetchedJob::open(master, id, tree_cache);
    if (!job) {
        return job.error();
    }
    job.value().prepared().spec.output.dir = dir;
    job.value().prepared().spec.output.formats.clear();
    FolderRunOptions options = folder_options({}, master);
    options.inputs_bytes_max = UINT64_MAX; // The inputs have no other local copy.
    const auto written = job.value().write(std::move(options), "text");
    return written ? Status(Done{}) : written.error();
}

Result<RunAtHand> opened(const std::filesystem::path& dir) {
    auto run = OpenedRun::open(dir);
    if (!run) {
        return run.error();
    }
    auto inputs = read_inputs(run.value());
    return inputs ? Result<RunAtHand>(RunAtHand{std::move(run.value()), std::move(inputs.value())})
                  : inputs.error();
}

} // namespace

Result<RunAtHand> RunAtHand::open(const std::string& argument,
                                  const MasterOptions& master,
                                  const std::filesystem::path& tree_cache) {
    if (is_folder(argument)) {
        return opened(argument);
    }
    InterruptGuard::begin_to_flag();
    const auto folder = make_temporary_folder("cdctl");
    if (!folder) {
        return folder.error();
    }
    const Status fetched = fetch_into(folder.value(), argument, master, tree_cache);
    auto run = fetched ? opened(folder.value()) : Result<RunAtHand>(fetched.error());
    std::error_code ignored;
    std::filesystem::remove_all(folder.value(), ignored);
    InterruptGuard::begin_to_end();
    return run;
}

Result<PreparedJob> RunAtHand::prepare(Trees trees, TreeCache& cache, ThreadPool& pool) {
    auto spec = run.spec();
    if (!spec) {
        return spec.error();
    }
    return prepare_again(
        run.manifest(), std::move(inputs), std::move(spec.value()), trees, cache, pool);
}

} // namespace cd
