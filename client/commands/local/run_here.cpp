#include "client/commands/local/run_here.hpp"

#include "client/base/interrupt.hpp"
#include "client/commands/run_command.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_run.hpp"
#include "client/local/local_report.hpp"
#include "client/local/local_run.hpp"
#include "client/report/progress.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/geometry/simd_target.hpp"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// The results of a run, and how many of them an earlier run had.
struct LocalOutcome : RunOutcome {
    std::uint64_t reused = 0;
    std::optional<std::uint64_t> ran = {}; ///< Nothing: all that were left.
};

RunReport report_of(const LocalJob& local, const LocalOutcome& outcome) {
    RunReport report = report_of(outcome, local.job.query, local.pool.size());
    report.execution.reused = outcome.reused;
    report.execution.ran = outcome.ran;
    report.execution.prepare_seconds = local.prepare_seconds;
    return report;
}

using TakeBlock = std::function<Status(const DoneBlock&)>;

/// Runs scenarios with a progress line. Passes all results to `take`; calls `tick` periodically.
Result<RunOutcome> run_with_progress(const LocalJob& local,
                                     PoseSource& poses,
                                     LocalRunOptions options,
                                     const TakeBlock& take,
                                     const std::function<void()>& tick) {
    ProgressPrinter progress(ProgressPrinter::style_for(local.command.quiet));
    options.first_stage = local.command.host.first_stage.value_or(PairStage::Float);
    options.scene = scene_head(local.job);
    const std::uint64_t resumed = options.done ? options.done->summary().merged() : 0;
    const RunObserver observer{
        take,
        [&](const Summary& summary, double seconds) {
            progress.update({local.job.spec.name, summary, seconds, {}, resumed});
            tick();
        },
        &InterruptGuard::has_come};
    auto outcome = run_locally(TreesByBody(local.job.trees),
                               poses,
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

/// Runs the scenarios that `reused` lacks. Passes its results and theirs to `take` in order, from
/// the first one on that `done` lacks.
Result<LocalOutcome> run_rest(const LocalJob& local,
                              ReusedResults& reused,
                              ResultMerger merger,
                              const TakeBlock& take,
                              const std::function<void()>& tick) {
    const std::uint64_t first = merger.summary().merged();
    const auto rest = reused.rest(*local.job.poses, first);
    ReuseMerge merge(
        reused,
        *rest,
        first,
        [&](const DoneScenario& done) -> Status {
            CD_TRY(take(block_of(done)));
            static_cast<void>(merger.add(done.result, done.digest));
            return Done{};
        },
        &InterruptGuard::has_come);
    LocalOutcome outcome;
    if (rest->count() != 0) {
        const auto add = [&](const DoneScenario& done) { return merge.add(done); };
        outcome = {CD_TRY(run_with_progress(
            local, *rest, {}, [&](const DoneBlock& done) { return done.for_each(add); }, tick))};
    }
    CD_TRY(merge.finish());
    outcome.summary = merger.summary();
    outcome.digest = merger.digest();
    outcome.reused = reused.count();
    outcome.ran = rest->count();
    return outcome;
}

/// Runs the job, or what an earlier run lacks of it. `done` holds the first results of the job, if
/// an interrupted run left any. Calls `count_reused`, if set, with the number of reused results
/// before it runs anything.
Result<LocalOutcome> run_or_reuse(const LocalJob& local,
                                  std::optional<ResultMerger> done,
                                  const std::function<void(std::uint64_t)>& count_reused,
                                  const TakeBlock& take,
                                  const std::function<void()>& tick) {
    if (local.earlier == nullptr) {
        LocalRunOptions options;
        options.done = std::move(done);
        return LocalOutcome{
            CD_TRY(run_with_progress(local, *local.job.poses, std::move(options), take, tick))};
    }
    auto reused = CD_TRY(local.earlier->results_for(local.job, local.command.quiet));
    count_reused(reused.count());
    return run_rest(local, reused, std::move(done).value_or(merger_of(local.job)), take, tick);
}

Error without_results(const Error& error) {
    return error.code == ErrorCode::Interrupted
               ? Error{error.code, "interrupted; no results were kept, since there was no --out"}
               : error;
}

Result<int> run_without_folder(const LocalJob& local) {
    const RunCommand& command = local.command;
    SinkOptions options{{}, {}, command.output};
    options.learn = local.job.spec.scene ? local.job.spec.scene->rules.learn : std::nullopt;
    auto sink = CD_TRY(ResultSink::open(std::move(options), export_context(local.job)));
    const auto outcome = run_or_reuse(
        local,
        std::nullopt,
        [](std::uint64_t) {},
        [&](const DoneBlock& results) {
            return results.for_each(
                [&](const DoneScenario& done) { return sink.add(done.result, done.found); });
        },
        [] {});
    if (!outcome) {
        return without_results(outcome.error());
    }
    RunReport report = report_of(local, outcome.value());
    if (Status told = add_hint(local.job, report); !told) {
        return without_results(told.error());
    }
    if (local.job.query.maps || local.job.query.level >= Level::Pairs) {
        report.map = sink.map();
    }
    CD_TRY(sink.finish(report.map));
    report.findings = sink.findings();
    return end_run(command, report, sink.uses_stdout());
}

/// Saves the results of an interrupted run. Returns `error`, with the number of results kept.
Error keep_results(const LocalJob& local, FolderRun& run, const Error& error) {
    if (const Status kept = run.keep(); !kept) {
        return kept.error();
    }
    const std::string what = "; " + grouped(run.kept()) + " of " +
                             grouped(local.job.poses->count()) + " are kept in " +
                             run.folder().dir().string() + "; the same command resumes the run";
    return {error.code, error.detail + what};
}

Result<int> run_into_folder(const LocalJob& local) {
    const RunCommand& command = local.command;
    FolderRunOptions options = folder_options(command.folder);
    options.where.threads = local.pool.size();
    options.where.simd = to_text(simd_target());
    if (local.earlier != nullptr) {
        options.reused = local.earlier->named();
    }
    auto run = CD_TRY(FolderRun::begin(local.job, std::move(options)));
    if (run.is_complete()) {
        return tell_complete(command, local.job, run);
    }
    auto done = CD_TRY(run.done());
    const std::uint64_t resumed_at = done.summary().merged();
    if (resumed_at != 0 && !command.quiet) {
        std::fprintf(stderr,
                     "resumed at %s of %s\n",
                     grouped(resumed_at).c_str(),
                     grouped(local.job.poses->count()).c_str());
    }
    Status ticked = Done{};
    const auto outcome = run_or_reuse(
        local,
        std::move(done),
        [&](std::uint64_t reused) { run.set_reused(reused); },
        [&](const DoneBlock& results) { return ticked ? run.add(results) : ticked; },
        [&] { ticked = ticked ? run.keep_if_due() : ticked; });
    if (!outcome) {
        return keep_results(local, run, outcome.error());
    }
    RunReport report = report_of(local, outcome.value());
    report.execution.resumed_at = resumed_at;
    const Status hinted = add_hint(local.job, report);
    const Status finished = hinted ? run.finish(report, command.output, std::nullopt) : hinted;
    if (!finished) {
        return keep_results(local, run, finished.error());
    }
    return end_run(command, report, command.output != "text");
}

} // namespace

Result<int> run_here(const LocalJob& local) {
    return local.job.spec.output.dir.empty() ? run_without_folder(local) : run_into_folder(local);
}

} // namespace cd
