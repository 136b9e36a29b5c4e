#include "client/commands/run_command.hpp"

#include "client/commands/commands.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/estimate.hpp"
#include "client/exit_code.hpp"
#include "client/heap.hpp"
#include "client/interrupt.hpp"
#include "client/local_run.hpp"
#include "client/poses/nearness.hpp"
#include "client/progress.hpp"
#include "client/words.hpp"
#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace cd {

namespace {

constexpr std::size_t touched_parts_shown = 3;

int run_here(const RunCommand& command, PreparedJob& job, ThreadPool& pool) {
    auto sink = ResultSink::open(job.spec.output, command.output, export_context(job));
    if (!sink) {
        return fail(sink.error());
    }
    ProgressPrinter progress(ProgressPrinter::style_for(command.quiet));
    const RunObserver observer{
        [&](const ScenarioResult& result) { return sink.value().add(result); },
        [&](const Summary& summary, double seconds) {
            progress.update({job.spec.name, summary, seconds});
        },
        [] { return InterruptGuard::signal() != 0; }};
    const auto outcome = run_locally(*job.trees[0],
                                     *job.trees[1],
                                     *job.poses,
                                     job.query,
                                     pool,
                                     observer,
                                     command.first_stage.value_or(PairStage::Float));
    if (!outcome) {
        return fail(outcome.error());
    }
    progress.finish({job.spec.name, outcome.value().summary, outcome.value().seconds});
    RunReport report;
    report.summary = outcome.value().summary;
    report.level = job.query.level;
    report.digest = outcome.value().digest;
    report.seconds = outcome.value().seconds;
    report.statistics = outcome.value().statistics;
    report.cost = outcome.value().cost;
    if (job.query.maps) {
        report.map = outcome.value().map;
    }
    report.where = counted(pool.size(), "thread");
    report.most_touched = sink.value().tally().most_touched(touched_parts_shown);
    report.hint = hint_of(job, report.summary);
    if (Status finished = sink.value().finish(report, command.quiet); !finished) {
        return fail(finished.error());
    }
    return exit_code_of(report.summary, command.fail_on);
}

} // namespace

namespace {

/// Before the inputs are read, which may take long.
Result<std::unique_ptr<Connection>> open_for_run(const RunCommand& command) {
    auto opened = open_master(command.master);
    if (!opened && opened.error().code == ErrorCode::Disconnected) {
        return Error{ErrorCode::Disconnected,
                     opened.error().detail + " without --master the job runs here"};
    }
    return opened;
}

/// The first line of a run: where it runs.
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
    return "  on " + command.master.address +
           (status ? ", " + counted(status.value().workers.size(), "worker") : "") + "\n";
}

} // namespace

namespace {

/// The answer to --dry-run.
int tell_estimate(const RunCommand& command, const PreparedJob& job, ThreadPool& pool) {
    EstimateOptions options;
    options.first_stage = command.first_stage.value_or(PairStage::Float);
    const auto estimate = estimate_run(job, pool, options);
    if (!estimate) {
        return fail(estimate.error());
    }
    const std::string text =
        command.output == "json"
            ? estimate_json(estimate.value())
            : "inputs are fine; " + estimate_text(estimate.value()) + "; nothing was run\n";
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

/// Whether the results fit, judged by so many samples that they take some percent of the run.
Status check_size(const PreparedJob& job, ThreadPool& pool) {
    EstimateOptions options;
    options.samples_max = std::min(options.samples_max, job.poses->count() / 20);
    options.time_max = std::chrono::milliseconds(2000);
    if (job.spec.output.dir.empty() || options.samples_max == 0) {
        return Done{};
    }
    const auto estimate = estimate_run(job, pool, options);
    // A run that cannot be estimated is no reason to refuse it.
    return estimate ? check_room(estimate.value(), job.spec.output) : Status(Done{});
}

} // namespace

Result<ResultSink>
ResultSink::open(const OutputSpec& spec, const std::string& output, const ExportContext& context) {
    ResultSink sink(PartTally(*context.meshes[0], *context.meshes[1]));
    if (!spec.dir.empty()) {
        auto files = ResultFiles::open(spec.dir, spec.formats, context);
        if (!files) {
            return files.error();
        }
        sink.files_.emplace(std::move(files.value()));
    }
    if (output == "json") {
        sink.stdout_writer_ = make_json_writer(context, OutputFile::standard_output());
    } else if (output == "csv") {
        sink.stdout_writer_ = make_scenarios_csv_writer(OutputFile::standard_output());
    }
    return sink;
}

Status ResultSink::add(const ScenarioResult& result) {
    tally_.add(result);
    if (files_) {
        if (Status added = files_->add(result); !added) {
            return added;
        }
    }
    return stdout_writer_ ? stdout_writer_->add(result) : Status(Done{});
}

Status ResultSink::finish(const RunReport& report, bool quiet) {
    if (files_) {
        if (Status finished = files_->finish(report); !finished) {
            return finished;
        }
    }
    if (stdout_writer_) {
        if (Status finished = stdout_writer_->finish(); !finished) {
            return finished;
        }
    }
    std::FILE* stream = stdout_writer_ ? stderr : stdout;
    if (!stdout_writer_ || !quiet) {
        std::string text = summary_text(report, colours_wanted(stream));
        text += files_ ? "  results       " + files_->dir().string() + "\n" : "";
        std::fputs(text.c_str(), stream);
        std::fflush(stream);
    }
    return Done{};
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
    auto spec = make_job_spec(command.job);
    if (!spec) {
        return fail(spec.error());
    }
    if (Status answerable = check_fail_on(command.fail_on, spec.value().level); !answerable) {
        return fail(answerable.error());
    }
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
    auto connection = here ? Result<std::unique_ptr<Connection>>(nullptr) : open_for_run(command);
    if (!connection) {
        return fail(connection.error());
    }
    if (!command.quiet) {
        std::fputs(where_text(command, connection.value().get(), pool).c_str(), stderr);
    }
    TreeCache cache(tree_cache_folder(command.tree_cache));
    auto job = prepare_job(std::move(spec.value()),
                           here || command.dry_run ? Trees::Always : Trees::ForPosesOnly,
                           cache,
                           pool,
                           command.quiet);
    if (!job) {
        return fail(job.error());
    }
    return_free_memory();
    print_header(job.value(), command.quiet);
    if (command.dry_run) {
        return tell_estimate(command, job.value(), pool);
    }
    if (here && !command.yes) {
        if (Status room = check_size(job.value(), pool); !room) {
            return fail(room.error());
        }
    }
    InterruptGuard::begin_to_flag();
    return here ? run_here(command, job.value(), pool)
                : run_on_master(command, job.value(), std::move(connection.value()));
}

} // namespace cd
