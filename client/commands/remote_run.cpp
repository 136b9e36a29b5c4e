// Runs a job on a master (`run --master`, `submit`): sends it, and fetches its results.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_run.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "web/status/job_id.hpp"
#include "web/status/table.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <optional>
#include <utility>

namespace cd {

namespace {

Result<int> report_without_folder(Connection& connection,
                                  const RunCommand& command,
                                  const PreparedJob& job,
                                  const JobStatus& status) {
    auto sink = CD_TRY(ResultSink::open({{}, {}, command.output}, export_context(job)));
    auto report = CD_TRY(fetch_results(connection, job.query, status, sink));
    CD_TRY(add_hint(job, report));
    if (!job.query.maps && job.query.level >= Level::Pairs) {
        report.map = sink.map();
    }
    CD_TRY(sink.finish(std::nullopt));
    return end_run(command, report, sink.uses_stdout());
}

Result<int> report_into_folder(Connection& connection,
                               const RunCommand& command,
                               const PreparedJob& job,
                               const JobStatus& status,
                               FolderRun& run) {
    const auto report = CD_TRY(fetch_results(connection, job, status, run, command.output, true));
    return end_run(command, report, command.output != "text");
}

std::string submitted_text(const SubmitCommand& command, const PreparedJob& job, JobId id) {
    const std::string text = job_id_text(id);
    if (command.output == "json") {
        return json_text({{"job", text},
                          {"number", id.value},
                          {"name", job.spec.name},
                          {"scenarios", job.poses->count()}});
    }
    if (command.output == "name") {
        return text + "\n";
    }
    return text + "  " + job.spec.name + ", " + counted(job.poses->count(), "scenario") +
           "; `cdctl watch " + text + "` shows how it goes\n";
}

/// Runs the job on a master. `folder` is null if the job has no output folder.
Result<int> run_there(const RunCommand& command,
                      PreparedJob& job,
                      std::unique_ptr<Connection> connection,
                      FolderRun* folder) {
    const JobId id = CD_TRY(send_job(*connection, job, command.quiet));
    const std::string text = job_id_text(id);
    const auto watched =
        watch_job(command.master, connection, id, text, ProgressPrinter::style_for(command.quiet));
    if (!watched) {
        if (watched.error().code == ErrorCode::Interrupted && connection->cancel(id)) {
            std::fprintf(
                stderr,
                "cdctl: job %s is cancelled; `cdctl results %s` gives the results so far\n",
                text.c_str(),
                text.c_str());
        }
        return watched.error();
    }
    const JobStatus& status = watched.value();
    CD_TRY(check_done(status, text));
    if (folder != nullptr) {
        folder->set_job(text, worker_count(*connection));
    }
    auto code = folder != nullptr ? report_into_folder(*connection, command, job, status, *folder)
                                  : report_without_folder(*connection, command, job, status);
    if (!code) {
        std::fprintf(stderr,
                     "cdctl: job %s is done; `cdctl results %s` fetches its results\n",
                     text.c_str(),
                     text.c_str());
    }
    return code;
}

} // namespace

Result<int>
run_on_master(const RunCommand& command, PreparedJob& job, std::unique_ptr<Connection> connection) {
    make_paths_absolute(job.spec);
    if (job.spec.output.dir.empty()) {
        return run_there(command, job, std::move(connection), nullptr);
    }
    auto folder = CD_TRY(FolderRun::begin(job, folder_options(command.folder, command.master)));
    if (folder.is_complete()) {
        return tell_complete(command, job, folder);
    }
    auto code = run_there(command, job, std::move(connection), &folder);
    folder.drop_unfinished();
    return code;
}

Result<int> perform(const SubmitCommand& command) {
    const InterruptGuard interrupts(InterruptGuard::First::EndsProcess);
    auto spec = CD_TRY(make_job_spec(command.job));
    auto connection = CD_TRY(open_master_for_job(command.master));
    ThreadPool pool(command.threads);
    TreeCache cache(tree_cache_folder(command.tree_cache));
    auto job =
        CD_TRY(prepare_job(std::move(spec), Trees::ForPosesOnly, cache, pool, command.quiet));
    make_paths_absolute(job.spec);
    print_header(job, command.quiet);
    InterruptGuard::begin_to_flag();
    const JobId id = CD_TRY(send_job(*connection, job, command.quiet));
    std::fputs(submitted_text(command, job, id).c_str(), stdout);
    return exit_done;
}

} // namespace cd
