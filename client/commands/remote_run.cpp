// run --master and submit: sends a prepared job to a master and fetches its results.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/job_id.hpp"
#include "client/base/words.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_run.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// Cancels the job after an interrupt. The master keeps the results so far.
int fail_and_cancel(Connection& connection, JobId job, const Error& error) {
    if (error.code == ErrorCode::Interrupted && connection.cancel(job)) {
        const std::string id = job_id_text(job);
        std::fprintf(stderr,
                     "cdctl: job %s is cancelled; `cdctl results %s` gives the results so far\n",
                     id.c_str(),
                     id.c_str());
    }
    return fail(error);
}

/// Reports an error while fetching the results of a completed job.
int fail_to_fetch(const std::string& job, const Error& error) {
    std::fprintf(stderr,
                 "cdctl: job %s is done; `cdctl results %s` fetches its results\n",
                 job.c_str(),
                 job.c_str());
    return fail(error);
}

Status report_without_folder(Connection& connection,
                             const RunCommand& command,
                             const PreparedJob& job,
                             const JobStatus& status) {
    auto sink = ResultSink::open({{}, {}, command.output}, export_context(job));
    if (!sink) {
        return sink.error();
    }
    const Status fetched =
        fetch_results(connection, status, [&](const ScenarioResult& result) -> Status {
            return sink.value().add(result);
        });
    if (!fetched) {
        return fetched;
    }
    auto told = fetched_report(connection, job.query, status);
    if (!told) {
        return told.error();
    }
    told.value().most_touched = sink.value().tally().most_touched();
    if (Status hinted = add_hint(job, told.value()); !hinted) {
        return hinted;
    }
    if (!job.query.maps && job.query.level >= Level::Pairs) {
        told.value().map = sink.value().map();
    }
    if (Status finished = sink.value().finish(std::nullopt); !finished) {
        return finished;
    }
    return print_summary(
        told.value(), sink.value().uses_stdout(), command.quiet, command.statistics);
}

Status report_into_folder(Connection& connection,
                          const RunCommand& command,
                          const PreparedJob& job,
                          const JobStatus& status,
                          FolderRun& run) {
    const Status fetched =
        fetch_results(connection, status, [&](const ScenarioResult& result) -> Status {
            return run.add({result, encode_result(result), {}, {}});
        });
    if (!fetched) {
        return fetched;
    }
    auto told = fetched_report(connection, job.query, status);
    if (!told) {
        return told.error();
    }
    if (Status hinted = add_hint(job, told.value()); !hinted) {
        return hinted;
    }
    const std::optional<ContactMap> map = told.value().map;
    if (Status finished = run.finish(told.value(), command.output, map); !finished) {
        return finished;
    }
    return print_summary(told.value(), command.output != "text", command.quiet, command.statistics);
}

std::string submitted_text(const SubmitCommand& command, const PreparedJob& job, JobId id) {
    const std::string text = job_id_text(id);
    if (command.output == "json") {
        nlohmann::ordered_json json{{"job", text},
                                    {"number", id.value},
                                    {"name", job.spec.name},
                                    {"scenarios", job.poses->count()}};
        return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    }
    if (command.output == "name") {
        return text + "\n";
    }
    return text + "  " + job.spec.name + ", " + counted(job.poses->count(), "scenario") +
           "; `cdctl watch " + text + "` shows how it goes\n";
}

/// Runs the job on a master. `folder` is null without an output folder.
int run_there(const RunCommand& command,
              PreparedJob& job,
              std::unique_ptr<Connection> connection,
              FolderRun* folder) {
    const Result<JobId> id = send_job(*connection, job, command.quiet);
    if (!id) {
        return fail(id.error());
    }
    const std::string text = job_id_text(id.value());
    const auto status = watch_job(
        command.master, connection, id.value(), text, ProgressPrinter::style_for(command.quiet));
    if (!status) {
        return fail_and_cancel(*connection, id.value(), status.error());
    }
    if (const Status done = check_done(status.value(), text); !done) {
        return fail(done.error());
    }
    if (folder != nullptr) {
        const auto cluster = connection->status();
        folder->set_job(text, cluster ? worker_count(cluster.value()) : 0);
    }
    const Status told = folder != nullptr
                            ? report_into_folder(*connection, command, job, status.value(), *folder)
                            : report_without_folder(*connection, command, job, status.value());
    if (!told) {
        return fail_to_fetch(text, told.error());
    }
    return exit_code_of(status.value().summary, command.fail_on);
}

} // namespace

int run_on_master(const RunCommand& command,
                  PreparedJob& job,
                  std::unique_ptr<Connection> connection) {
    make_paths_absolute(job.spec);
    if (job.spec.output.dir.empty()) {
        return run_there(command, job, std::move(connection), nullptr);
    }
    auto folder = FolderRun::begin(job, folder_options(command.folder, command.master));
    if (!folder) {
        return fail(folder.error());
    }
    if (folder.value().is_complete()) {
        return tell_complete(command, job, folder.value());
    }
    const int code = run_there(command, job, std::move(connection), &folder.value());
    folder.value().drop_unfinished();
    return code;
}

int execute(const SubmitCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    auto spec = make_job_spec(command.job);
    if (!spec) {
        return fail(spec.error());
    }
    auto connection = open_master_for_job(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    ThreadPool pool(command.threads);
    TreeCache cache(tree_cache_folder(command.tree_cache));
    auto job =
        prepare_job(std::move(spec.value()), Trees::ForPosesOnly, cache, pool, command.quiet);
    if (!job) {
        return fail(job.error());
    }
    make_paths_absolute(job.value().spec);
    print_header(job.value(), command.quiet);
    InterruptGuard::begin_to_flag();
    const Result<JobId> id = send_job(*connection.value(), job.value(), command.quiet);
    if (!id) {
        return fail(id.error());
    }
    std::fputs(submitted_text(command, job.value(), id.value()).c_str(), stdout);
    return exit_done;
}

} // namespace cd
