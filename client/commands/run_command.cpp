#include "client/commands/run_command.hpp"

#include "client/commands/commands.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/exit_code.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/heap.hpp"
#include "client/interrupt.hpp"
#include "client/local_run.hpp"
#include "client/poses/nearness.hpp"
#include "client/words.hpp"
#include "common/geometry/simd_target.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t touched_parts_shown = 3;

/// A prepared job with all that a run of it here needs.
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
    report.digest = outcome.digest;
    report.seconds = outcome.seconds;
    report.statistics = outcome.statistics;
    report.cost = outcome.cost;
    report.where = counted(local.pool.size(), "thread");
    report.prepare_seconds = local.prepare_seconds;
    return report;
}

/// Runs the job with a progress line; `take` gets each result, `tick` is called now and then.
Result<RunOutcome> run_with_progress(const LocalJob& local,
                                     LocalRunOptions options,
                                     const std::function<Status(const DoneScenario&)>& take,
                                     const std::function<void()>& tick) {
    ProgressPrinter progress(ProgressPrinter::style_for(local.command.quiet));
    options.first_stage = local.command.first_stage.value_or(PairStage::Float);
    const RunObserver observer{take,
                               [&](const Summary& summary, double seconds) {
                                   progress.update({local.job.spec.name, summary, seconds});
                                   tick();
                               },
                               [] { return InterruptGuard::signal() != 0; }};
    auto outcome = run_locally(*local.job.trees[0],
                               *local.job.trees[1],
                               *local.job.poses,
                               local.job.query,
                               local.pool,
                               observer,
                               std::move(options));
    if (outcome) {
        progress.finish({local.job.spec.name, outcome.value().summary, outcome.value().seconds});
    }
    return outcome;
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
    if (!outcome && outcome.error().code == ErrorCode::Interrupted) {
        return fail({ErrorCode::Interrupted,
                     "interrupted; no results were kept, since there was no --out"});
    }
    if (!outcome) {
        return fail(outcome.error());
    }
    RunReport report = report_of(local, outcome.value());
    report.most_touched = sink.value().tally().most_touched(touched_parts_shown);
    report.hint = hint_of(local.job, report.summary);
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

/// After a run that ended early: what of it is kept.
int fail_and_keep(const LocalJob& local, FolderRun& run, const Error& error) {
    const Status kept = run.keep();
    if (!kept) {
        return fail(kept.error());
    }
    const std::string what =
        "; " + grouped(run.kept()) + " of " + grouped(local.job.poses->count()) + " are kept in " +
        run.folder().dir().string() + ", and the same command goes on from there";
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
    for (const std::string& remark : run.value().remarks()) {
        std::fprintf(stderr, "%s\n", remark.c_str());
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
    report.resumed_at = resumed_at;
    report.hint = hint_of(local.job, report.summary);
    if (Status finished = run.value().finish(report, command.output, std::nullopt); !finished) {
        return fail(finished.error());
    }
    const Status told =
        print_summary(report, command.output != "text", command.quiet, command.statistics);
    return told ? exit_code_of(report.summary, command.fail_on) : fail(told.error());
}

/// The job of a results folder, or of a job file, with what the command line changes.
Result<PreparedJob>
prepare(const RunCommand& command, Trees trees, TreeCache& cache, ThreadPool& pool) {
    if (!is_folder(command.job.file)) {
        auto spec = make_job_spec(command.job);
        return spec ? prepare_job(std::move(spec.value()), trees, cache, pool)
                    : Result<PreparedJob>(spec.error());
    }
    const auto run = OpenedRun::open(command.job.file);
    if (!run) {
        return run.error();
    }
    JobSpec spec = spec_of(run.value().manifest());
    if (Status applied = apply(command.job, spec); !applied) {
        return applied.error();
    }
    return prepare_again(run.value(), std::move(spec), trees, cache, pool);
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
                     "%s holds this run already, of %s: digest %s; --fresh runs it again\n",
                     run.folder().dir().string().c_str(),
                     manifest.started.c_str(),
                     to_short_hex(*manifest.digest).c_str());
    }
    const auto summary = add_exports(opened.value(),
                                     run.folder(),
                                     export_context(job),
                                     {job.spec.output.formats, command.output, false});
    if (!summary) {
        return fail(summary.error());
    }
    return exit_code_of(summary.value(), command.fail_on);
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

std::string hint_of(const PreparedJob& job, const Summary& summary) {
    return summary.separate == summary.total
               ? nearness_hint(*job.meshes[0], *job.meshes[1], *job.poses, job.spec.unit)
               : std::string();
}

int run_job(const RunCommand& command) {
    const auto start = std::chrono::steady_clock::now();
    const bool here = command.master.address.empty();
    if (command.first_stage && !here) {
        return fail({ErrorCode::BadInput, "--first-stage is for a run on this machine alone"});
    }
    const Status simd =
        command.simd.empty() ? check_simd_environment() : force_simd_target(command.simd);
    if (!simd) {
        return fail(simd.error());
    }
    ThreadPool pool(command.threads);
    TreeCache cache(tree_cache_folder(command.tree_cache));
    auto job = prepare(command, here ? Trees::Always : Trees::ForPosesOnly, cache, pool);
    if (!job) {
        return fail(job.error());
    }
    if (Status answerable = check_fail_on(command.fail_on, job.value().spec.level); !answerable) {
        return fail(answerable.error());
    }
    return_free_memory();
    print_header(job.value(), command.quiet);
    if (command.dry_run) {
        return exit_done;
    }
    InterruptGuard::begin_to_flag();
    if (!here) {
        return run_on_master(command, job.value());
    }
    const std::chrono::duration<double> prepared = std::chrono::steady_clock::now() - start;
    const LocalJob local{command, job.value(), pool, prepared.count()};
    return job.value().spec.output.dir.empty() ? run_without_folder(local) : run_into_folder(local);
}

} // namespace cd
