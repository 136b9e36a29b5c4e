#include "client/commands/run_command.hpp"

#include "client/base/exit_code.hpp"
#include "client/base/heap.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/words.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/estimate.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/local/local_run.hpp"
#include "client/poses/nearness.hpp"
#include "client/report/progress.hpp"
#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// A prepared job and the resources to run it in this process.
struct LocalJob {
    const RunCommand& command;
    PreparedJob& job;
    ThreadPool& pool;
    double prepare_seconds = 0;
};

RunReport report_of(const LocalJob& local, const RunOutcome& outcome) {
    RunReport report;
    report.summary = outcome.summary;
    report.level = local.job.query.level;
    report.limit_pairs = local.job.query.limit_pairs;
    report.maps_all_pairs = local.job.query.maps;
    report.digest = outcome.digest;
    report.execution.seconds = outcome.seconds;
    report.execution.statistics = outcome.statistics;
    report.execution.cost = outcome.cost;
    report.execution.where = counted(local.pool.size(), "thread");
    report.execution.prepare_seconds = local.prepare_seconds;
    return report;
}

/// Runs the job with a progress line. Passes each result to `take`; calls `tick` periodically.
Result<RunOutcome> run_with_progress(const LocalJob& local,
                                     LocalRunOptions options,
                                     const std::function<Status(const DoneScenario&)>& take,
                                     const std::function<void()>& tick) {
    ProgressPrinter progress(ProgressPrinter::style_for(local.command.quiet));
    options.first_stage = local.command.host.first_stage.value_or(PairStage::Float);
    const std::uint64_t resumed = options.done ? options.done->summary().merged() : 0;
    const RunObserver observer{
        take,
        [&](const Summary& summary, double seconds) {
            progress.update({local.job.spec.name, summary, seconds, {}, resumed});
            tick();
        },
        &InterruptGuard::has_come};
    auto outcome = run_locally(*local.job.trees[0],
                               *local.job.trees[1],
                               *local.job.poses,
                               local.job.query,
                               local.pool,
                               observer,
                               std::move(options));
    if (outcome) {
        progress.finish(
            {local.job.spec.name, outcome.value().summary, outcome.value().seconds, {}, resumed});
    }
    return outcome;
}

int fail_without_folder(const Error& error) {
    return fail(
        error.code == ErrorCode::Interrupted
            ? Error{error.code, "interrupted; no results were kept, since there was no --out"}
            : error);
}

int run_without_folder(const LocalJob& local) {
    const RunCommand& command = local.command;
    auto sink = ResultSink::open({{}, {}, command.output}, export_context(local.job));
    if (!sink) {
        return fail(sink.error());
    }
    const auto outcome = run_with_progress(
        local,
        {},
        [&](const DoneScenario& done) { return sink.value().add(done.result, done.found); },
        [] {});
    if (!outcome) {
        return fail_without_folder(outcome.error());
    }
    RunReport report = report_of(local, outcome.value());
    report.most_touched = sink.value().tally().most_touched();
    if (Status told = add_hint(local.job, report); !told) {
        return fail_without_folder(told.error());
    }
    if (local.job.query.maps || local.job.query.level >= Level::Pairs) {
        report.map = sink.value().map();
    }
    if (Status finished = sink.value().finish(std::nullopt); !finished) {
        return fail(finished.error());
    }
    const Status told =
        print_summary(report, sink.value().uses_stdout(), command.quiet, command.statistics);
    return told ? exit_code_of(report.summary, command.fail_on) : fail(told.error());
}

/// Saves the results of an interrupted run and reports the error.
int fail_and_keep(const LocalJob& local, FolderRun& run, const Error& error) {
    const Status kept = run.keep();
    if (!kept) {
        return fail(kept.error());
    }
    const std::string what = "; " + grouped(run.kept()) + " of " +
                             grouped(local.job.poses->count()) + " are kept in " +
                             run.folder().dir().string() + "; the same command resumes the run";
    return fail({error.code, error.detail + what});
}

int run_into_folder(const LocalJob& local) {
    const RunCommand& command = local.command;
    FolderRunOptions options = folder_options(command.folder);
    options.where.threads = local.pool.size();
    options.where.simd = to_text(simd_target());
    auto run = FolderRun::begin(local.job, std::move(options));
    if (!run) {
        return fail(run.error());
    }
    if (run.value().is_complete()) {
        return tell_complete(command, local.job, run.value());
    }
    auto done = run.value().done();
    if (!done) {
        return fail(done.error());
    }
    const std::uint64_t resumed_at = done.value().summary().merged();
    if (resumed_at != 0 && !command.quiet) {
        std::fprintf(stderr,
                     "resumed at %s of %s\n",
                     grouped(resumed_at).c_str(),
                     grouped(local.job.poses->count()).c_str());
    }
    LocalRunOptions run_options;
    run_options.done = std::move(done.value());
    Status ticked = Done{};
    const auto outcome = run_with_progress(
        local,
        std::move(run_options),
        [&](const DoneScenario& result) { return ticked ? run.value().add(result) : ticked; },
        [&] { ticked = ticked ? run.value().keep_if_due() : ticked; });
    if (!outcome) {
        return fail_and_keep(local, run.value(), outcome.error());
    }
    RunReport report = report_of(local, outcome.value());
    report.execution.resumed_at = resumed_at;
    const Status hinted = add_hint(local.job, report);
    const Status finished =
        hinted ? run.value().finish(report, command.output, std::nullopt) : hinted;
    if (!finished) {
        return fail_and_keep(local, run.value(), finished.error());
    }
    const Status told =
        print_summary(report, command.output != "text", command.quiet, command.statistics);
    return told ? exit_code_of(report.summary, command.fail_on) : fail(told.error());
}

/// The job of the command line: from a job file, options, or a results folder.
struct AskedJob {
    JobSpec spec;
    std::optional<OpenedRun> run; ///< Set for a results folder.
};

/// Reads the job, but none of its inputs. Errors: those of `make_job_spec` and `OpenedRun::open`.
Result<AskedJob> asked_job(const JobOptions& options) {
    if (!is_folder(options.file)) {
        auto spec = make_job_spec(options);
        return spec ? Result<AskedJob>(AskedJob{std::move(spec.value()), std::nullopt})
                    : spec.error();
    }
    if (Status none = check_no_inputs(options); !none) {
        return none.error();
    }
    if (!options.precision.empty()) {
        return Error{ErrorCode::BadInput,
                     options.file + " holds the meshes as they were tested, so --precision has no "
                                    "effect: give the job file"};
    }
    auto run = OpenedRun::open(options.file);
    if (!run) {
        return run.error();
    }
    auto spec = run.value().spec();
    if (!spec) {
        return spec.error();
    }
    if (Status applied = apply(options, spec.value()); !applied) {
        return applied.error();
    }
    return AskedJob{std::move(spec.value()), std::move(run.value())};
}

Result<PreparedJob>
prepare(AskedJob asked, Trees trees, TreeCache& cache, ThreadPool& pool, bool quiet) {
    if (!asked.run) {
        return prepare_job(std::move(asked.spec), trees, cache, pool, quiet);
    }
    auto inputs = read_inputs(*asked.run);
    return inputs ? prepare_again(asked.run->manifest(),
                                  std::move(inputs.value()),
                                  std::move(asked.spec),
                                  trees,
                                  cache,
                                  pool,
                                  quiet)
                  : inputs.error();
}

/// The first line that a run prints: where it runs. `connection` is null for this machine.
std::string where_text(const RunCommand& command, Connection* connection, const ThreadPool& pool) {
    if (connection == nullptr) {
        const char* master = std::getenv("CDCTL_MASTER");
        return "  here, " + counted(pool.size(), "thread") +
               (master == nullptr || *master == '\0'
                    ? ""
                    : "; to run on CDCTL_MASTER: --master " + std::string(master)) +
               "\n";
    }
    const Result<ClusterStatus> status = connection->status();
    return "  on " + command.master.address + (status ? ", " + workers_text(status.value()) : "") +
           "\n";
}

EstimateOptions estimate_options(const RunCommand& command) {
    EstimateOptions options;
    options.first_stage = command.host.first_stage.value_or(PairStage::Float);
    options.keeps_inputs = !command.folder.no_inputs;
    return options;
}

/// Prints the answer to --dry-run.
int tell_estimate(const RunCommand& command, const PreparedJob& job, ThreadPool& pool) {
    const auto estimate = estimate_run(job, pool, estimate_options(command));
    if (!estimate) {
        return fail(estimate.error());
    }
    const Status room =
        command.yes ? Status(Done{})
                    : check_room(estimate.value(), job.spec.output, command.results_bytes_max);
    std::string text = "inputs are fine; " + estimate_text(estimate.value()) +
                       "; nothing was run\n" + (room ? "" : room.error().detail + "\n");
    if (command.output == "json") {
        text = estimate_json(estimate.value(), room);
    }
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

/// True if the size of the results must be checked before the run.
bool checks_size(const RunCommand& command, const JobSpec& spec) {
    return !command.yes && !spec.output.dir.empty();
}

/// Refuses results that are too large. Samples at most 5 % of the scenarios, so the check is cheap.
/// Errors: those of `check_room`.
Status check_size(const RunCommand& command, const PreparedJob& job, ThreadPool& pool) {
    EstimateOptions options = estimate_options(command);
    options.samples_max = std::min(options.samples_max, job.poses->count() / 20);
    options.time_max = std::chrono::milliseconds(2000);
    if (!checks_size(command, job.spec) || options.samples_max == 0) {
        return Done{};
    }
    const auto estimate = estimate_run(job, pool, options);
    // A failed estimate is no reason to refuse the run.
    return estimate ? check_room(estimate.value(), job.spec.output, command.results_bytes_max)
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

int tell_complete(const RunCommand& command, const PreparedJob& job, FolderRun& run) {
    const RunManifest manifest = *run.folder().finished();
    const auto opened = OpenedRun::open(run.folder().dir());
    if (!opened) {
        return fail(opened.error());
    }
    if (!command.quiet) {
        std::fprintf(stderr,
                     "%s already holds this run (of %s): digest %s; --fresh runs it again\n",
                     run.folder().dir().string().c_str(),
                     manifest.origin.started.c_str(),
                     to_short_hex(*manifest.outcome.digest).c_str());
    }
    const auto report = add_exports(opened.value(),
                                    &run.folder(),
                                    export_context(job),
                                    {job.spec.output.formats, command.output, false});
    if (!report) {
        return fail(report.error());
    }
    return exit_code_of(report.value().summary, command.fail_on);
}

void print_header(const PreparedJob& job, bool quiet) {
    for (const std::string& warning : job.warnings) {
        std::fprintf(stderr, "%s\n", warning.c_str());
    }
    if (!quiet) {
        std::fputs(job.header.c_str(), stderr);
    }
}

int execute(const RunCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    return run_job(command);
}

Status add_hint(const PreparedJob& job, RunReport& report) {
    if (report.summary.separate != report.summary.total) {
        return Done{};
    }
    auto hint = nearness_hint(
        *job.meshes[0], *job.meshes[1], *job.poses, job.spec.unit, &InterruptGuard::has_come);
    if (!hint) {
        return hint.error();
    }
    report.hint = std::move(hint.value());
    return Done{};
}

int run_job(const RunCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const bool here = command.master.address.empty();
    if (command.host.first_stage && !here) {
        return fail({ErrorCode::BadInput, "--first-stage is for a run on this machine alone"});
    }
    const Status simd =
        command.host.simd.empty() ? check_simd_environment() : force_simd_target(command.host.simd);
    if (!simd) {
        return fail(simd.error());
    }
    auto asked = asked_job(command.job);
    if (!asked) {
        return fail(asked.error());
    }
    ThreadPool pool(command.host.threads);
    auto connection =
        here ? Result<std::unique_ptr<Connection>>(nullptr) : open_master_for_job(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    if (!command.quiet) {
        std::fputs(where_text(command, connection.value().get(), pool).c_str(), stderr);
    }
    TreeCache cache(tree_cache_folder(command.host.tree_cache));
    const bool samples_run = command.dry_run || checks_size(command, asked.value().spec);
    auto job = prepare(std::move(asked.value()),
                       here || samples_run ? Trees::Always : Trees::ForPosesOnly,
                       cache,
                       pool,
                       command.quiet);
    if (!job) {
        return fail(job.error());
    }
    if (Status answerable = check_fail_on(command.fail_on, job.value().spec.level); !answerable) {
        return fail(answerable.error());
    }
    return_free_memory();
    print_header(job.value(), command.quiet);
    if (command.dry_run) {
        return tell_estimate(command, job.value(), pool);
    }
    if (Status room = check_size(command, job.value(), pool); !room) {
        return fail(room.error());
    }
    InterruptGuard::begin_to_flag();
    if (!here) {
        return run_on_master(command, job.value(), std::move(connection.value()));
    }
    const std::chrono::duration<double> prepared = std::chrono::steady_clock::now() - start;
    const LocalJob local{command, job.value(), pool, prepared.count()};
    return job.value().spec.output.dir.empty() ? run_without_folder(local) : run_into_folder(local);
}

} // namespace cd
