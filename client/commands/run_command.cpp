#include "client/commands/run_command.hpp"

#include "client/base/exit_code.hpp"
#include "client/base/heap.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/compare/earlier_run.hpp"
#include "client/commands/compare/judge.hpp"
#include "client/commands/estimate.hpp"
#include "client/commands/local/run_here.hpp"
#include "client/commands/remote_session.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/poses/nearness.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// The job that a command line names: by a job file, by options, or by a results folder.
struct AskedJob {
    JobSpec spec;
    std::optional<OpenedRun> run; ///< Set for a results folder.
};

/// Reads a job, but none of its inputs. Errors: as `make_job_spec` and `OpenedRun::open`.
Result<AskedJob> asked_job(const JobOptions& options) {
    if (!is_folder(options.file)) {
        auto spec = CD_TRY(make_job_spec(options));
        return AskedJob{std::move(spec), std::nullopt};
    }
    CD_TRY(check_no_inputs(options));
    if (!options.precision.empty()) {
        return bad_input(options.file +
                         " holds the meshes as they were tested, so --precision has no "
                         "effect: give the job file");
    }
    auto run = CD_TRY(OpenedRun::open(options.file));
    CD_TRY(check_exact(run.manifest()));
    auto spec = CD_TRY(run.spec());
    CD_TRY(apply(options, spec));
    return AskedJob{std::move(spec), std::move(run)};
}

Result<PreparedJob>
prepare(AskedJob asked, Trees trees, TreeCache& cache, ThreadPool& pool, bool quiet) {
    if (!asked.run) {
        return prepare_job(std::move(asked.spec), trees, cache, pool, quiet);
    }
    auto inputs = CD_TRY(read_inputs(*asked.run));
    return prepare_again(
        asked.run->manifest(), std::move(inputs), std::move(asked.spec), trees, cache, pool, quiet);
}

/// Returns the first line of a run: where it runs. `connection` is null for this machine.
std::string where_text(const RunCommand& command, Connection* connection, const ThreadPool& pool) {
    if (connection == nullptr) {
        const char* master = std::getenv("CDCTL_MASTER");
        return "  here, " + counted(pool.size(), "thread") +
               (master == nullptr || *master == '\0'
                    ? ""
                    : "; to run on CDCTL_MASTER: --master " + std::string(master)) +
               "\n";
    }
    const std::string workers = workers_text(*connection);
    return "  on " + command.master.address + (workers.empty() ? "" : ", " + workers) + "\n";
}

EstimateOptions estimate_options(const RunCommand& command) {
    EstimateOptions options;
    options.first_stage = command.host.first_stage.value_or(PairStage::Float);
    options.keeps_inputs = !command.folder.no_inputs;
    return options;
}

/// Opens what the run is judged by; nothing if it is not judged. Errors: as `Judge::open`; BadInput
/// for a run without a folder, whose groups come from its records.
Result<std::optional<Judge>>
judge_of(const RunCommand& command, const JobSpec& spec, ThreadPool& pool) {
    if (command.judge.is_empty() && !command.fail_on.news) {
        return std::optional<Judge>();
    }
    auto judge = CD_TRY(
        Judge::open(command.judge, command.fail_on, command.master, command.host.tree_cache, pool));
    if (spec.output.dir.empty()) {
        return bad_input("--baseline and --statuses read the results folder: give --out");
    }
    return std::optional<Judge>(std::move(judge));
}

/// Estimates time and size, and prints them as the answer to --dry-run. Both are those of a run
/// that reuses nothing; how much can be reused is said on stderr.
Result<int> tell_estimate(const RunCommand& command,
                          const PreparedJob& job,
                          ThreadPool& pool,
                          EarlierRun* earlier) {
    if (earlier != nullptr) {
        static_cast<void>(CD_TRY(earlier->results_for(job, false)));
    }
    const auto estimate = CD_TRY(estimate_run(job, pool, estimate_options(command)));
    const Status room = command.room.yes
                            ? Status(Done{})
                            : check_room(estimate, job.spec.output, command.room.results_bytes_max);
    std::string text = "inputs are fine; " + estimate_text(estimate) + "; nothing was run\n" +
                       (room ? "" : room.error().detail + "\n");
    if (command.output == "json") {
        text = estimate_json(estimate, room);
    }
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

/// True if the size of the results must be checked before the run.
bool checks_size(const RunCommand& command, const JobSpec& spec) {
    return !command.room.yes && !spec.output.dir.empty();
}

/// Refuses results that are too large. Samples at most 5 % of the scenarios, so the check is cheap.
/// Errors: as `check_room`.
Status check_size(const RunCommand& command, const PreparedJob& job, ThreadPool& pool) {
    EstimateOptions options = estimate_options(command);
    options.samples_max = std::min(options.samples_max, job.poses->count() / 20);
    options.time_max = std::chrono::milliseconds(2000);
    if (!checks_size(command, job.spec) || options.samples_max == 0) {
        return Done{};
    }
    const auto estimate = estimate_run(job, pool, options);
    // If the estimate fails, the run goes on without the check.
    return estimate ? check_room(estimate.value(), job.spec.output, command.room.results_bytes_max)
                    : Status(Done{});
}

} // namespace

FolderRunOptions folder_options(const FolderFlags& flags) {
    FolderRunOptions options;
    options.folder = {flags.overwrite, flags.fresh};
    options.keep_inputs = !flags.no_inputs;
    options.command = own_command_line();
    return options;
}

FolderRunOptions folder_options(const FolderFlags& flags, const MasterOptions& master) {
    FolderRunOptions options = folder_options(flags);
    options.folder.resume = false;
    options.maps_from_master = true;
    options.where.master = master.address;
    return options;
}

Result<int> tell_complete(const RunCommand& command, const PreparedJob& job, FolderRun& run) {
    const RunManifest manifest = *run.folder().finished();
    const auto opened = CD_TRY(OpenedRun::open(run.folder().dir()));
    if (!command.quiet) {
        std::fprintf(stderr,
                     "%s already holds this run (of %s): digest %s; --fresh runs it again\n",
                     run.folder().dir().string().c_str(),
                     manifest.origin.started.c_str(),
                     to_short_hex(*manifest.outcome.digest).c_str());
    }
    const auto report = CD_TRY(add_exports(opened,
                                           &run.folder(),
                                           export_context(job),
                                           {job.spec.output.formats, command.output, false}));
    return exit_code_of(report.summary, command.fail_on);
}

void print_header(const PreparedJob& job, bool quiet) {
    for (const std::string& warning : job.warnings) {
        std::fprintf(stderr, "%s\n", warning.c_str());
    }
    if (!quiet) {
        std::fputs(job.header.c_str(), stderr);
    }
}

Result<int> end_run(const RunCommand& command, const RunReport& report, bool stdout_is_used) {
    CD_TRY(print_summary(report, stdout_is_used, command.quiet, command.statistics));
    return exit_code_of(report.summary, command.fail_on);
}

Result<int> perform(const RunCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    return run_job(command);
}

Status add_hint(const PreparedJob& job, RunReport& report) {
    // Lines may well miss a body; that says nothing about units.
    if (job.scene || report.summary.separate != report.summary.total ||
        job.query.question == Question::Shots) {
        return Done{};
    }
    report.hint = CD_TRY(nearness_hint(*job.meshes[0],
                                       *job.meshes[1],
                                       *job.poses,
                                       job.spec.unit,
                                       job.query.motion ? "key of a motion" : "pose",
                                       &InterruptGuard::has_come));
    return Done{};
}

Result<int> run_job(const RunCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const bool here = command.master.address.empty();
    if (command.host.first_stage && !here) {
        return bad_input("--first-stage is for a run on this machine alone; --master here asks for "
                         "one");
    }
    if (command.master.priority && here) {
        return bad_input("--priority is for jobs on a master: give --master");
    }
    CD_TRY(command.host.simd.empty() ? check_simd_environment()
                                     : force_simd_target(command.host.simd));
    auto asked = CD_TRY(asked_job(command.job));
    ThreadPool pool(command.host.threads);
    std::unique_ptr<Connection> connection;
    if (!here) {
        connection = CD_TRY(open_master_for_job(command.master));
    }
    if (!command.quiet) {
        std::fputs(where_text(command, connection.get(), pool).c_str(), stderr);
    }
    TreeCache cache(tree_cache_folder(command.host.tree_cache));
    const bool samples_run = command.dry_run || checks_size(command, asked.spec);
    auto job = CD_TRY(prepare(std::move(asked),
                              here || samples_run ? Trees::Always : Trees::ForPosesOnly,
                              cache,
                              pool,
                              command.quiet));
    CD_TRY(check_fail_on(command.fail_on, job.query));
    keep_freed_memory();
    print_header(job, command.quiet);
    std::optional<EarlierRun> earlier;
    if (!command.reuse.empty()) {
        earlier = CD_TRY(
            EarlierRun::open(command.reuse, command.master, command.host.tree_cache, job, pool));
    }
    EarlierRun* const reuses = earlier ? &*earlier : nullptr;
    auto judge = CD_TRY(judge_of(command, job.spec, pool));
    const std::string dir = job.spec.output.dir.string();
    if (command.dry_run) {
        return tell_estimate(command, job, pool, reuses);
    }
    CD_TRY(check_size(command, job, pool));
    InterruptGuard::begin_to_flag();
    int code = exit_done;
    if (here) {
        const std::chrono::duration<double> prepared = std::chrono::steady_clock::now() - start;
        code = CD_TRY(run_here({command, job, pool, reuses, prepared.count()}));
    } else {
        code = CD_TRY(run_on_master(command, job, std::move(connection), reuses));
    }
    if (judge) {
        const bool has_news = CD_TRY(judge_folder(*judge, command, dir, pool));
        code = code == exit_done && command.fail_on.news && has_news ? exit_contacts : code;
    }
    return code;
}

} // namespace cd
