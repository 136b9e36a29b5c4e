// The verb `results`, for a results folder or a job on a master.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/cluster/fetched_job.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/commands/run_command.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// Prints the summary, unless `prints` says that the results themselves were printed as text.
/// Returns the exit code: missing results are a failure here, contacts are not.
Result<int> tell(const ResultsCommand& command, const RunReport& report, bool prints) {
    if (!prints) {
        CD_TRY(print_summary(report, command.output != "text", command.quiet, command.statistics));
    }
    return exit_code_of(report.summary, FailOn());
}

Result<int> results_of_job(const ResultsCommand& command) {
    auto connected = CD_TRY(open_job_of_argument(command.master, command.job));
    auto job =
        CD_TRY(FetchedJob::open(std::move(connected), tree_cache_folder(command.tree_cache)));
    OutputSpec& output = job.prepared().spec.output;
    output.dir = command.out;
    output.exact_points = command.exact_points;
    const Query& query = job.prepared().query;
    const MapUse use{query.level, query.maps, job.prepared().scene.has_value()};
    if (command.formats.empty()) {
        take_usual_formats(command.usual_formats, use, output.formats);
    } else {
        output.formats = command.formats;
    }
    if (!command.out.empty()) {
        CD_TRY(check_map_formats(output.formats, use));
    }
    const bool prints = command.out.empty() && command.output == "text";
    const auto report =
        CD_TRY(command.out.empty()
                   ? job.print(prints ? "records-text" : command.output)
                   : job.write(folder_options(command.folder, command.master), command.output));
    const JobStatus& status = job.status();
    if (status.state == JobState::Done) {
        return tell(command, report, prints);
    }
    const bool says_why = status.state == JobState::Failed && !status.failure.empty();
    std::fprintf(stderr,
                 "cdctl: incomplete: %s of %s scenarios have a result; the job is %s%s\n",
                 grouped(report.execution.fetched).c_str(),
                 grouped(status.summary.total).c_str(),
                 std::string(to_text(status.state)).c_str(),
                 says_why ? (": " + status.failure).c_str() : "");
    CD_TRY(tell(command, report, prints));
    return exit_incomplete;
}

/// Prints the summary.json of a folder that an earlier version wrote, without records. Returns the
/// error `no_run` if the command needs records.
Result<int> results_of_summary(const ResultsCommand& command, const Error& no_run) {
    if (!command.formats.empty() || command.output == "csv") {
        return no_run;
    }
    const fs::path path = fs::path(command.job) / "summary.json";
    const RunReport report = CD_TRY(read_summary(path));
    OutputFile out = OutputFile::standard_output();
    const std::string json = CD_TRY(read_file(path));
    CD_TRY(out.write(
        command.output == "json" ? json : summary_text(report, {colours_wanted(stdout), false})));
    CD_TRY(out.commit());
    return exit_code_of(report.summary, FailOn());
}

/// Writes the results in a folder to further formats in that folder. Without formats, the results
/// go to stdout, and no file is written.
Result<int> results_of_folder(const ResultsCommand& command) {
    if (!command.out.empty()) {
        return bad_input("formats of a folder are written into it; leave out --out, or copy the "
                         "folder first");
    }
    auto opened = OpenedRun::open(command.job);
    if (!opened && holds_only_a_summary(command.job)) {
        return results_of_summary(command, opened.error());
    }
    const OpenedRun run = CD_TRY(std::move(opened));
    auto context = CD_TRY(export_context(run));
    context.exact_points = command.exact_points;
    InterruptGuard::begin_to_flag(); // From here on, a signal must not leave partial files.
    std::optional<RunFolder> folder;
    if (!command.formats.empty()) {
        folder.emplace(CD_TRY(RunFolder::open_finished(run.dir(), run.manifest())));
    }
    const bool prints = command.formats.empty() && command.output == "text";
    const RunReport report =
        CD_TRY(add_exports(run,
                           folder ? &*folder : nullptr,
                           context,
                           {command.formats, prints ? "records-text" : command.output, true}));
    if (!report.summary.is_complete()) {
        std::fprintf(stderr,
                     "cdctl: incomplete: %s of %s scenarios have a result\n",
                     grouped(report.summary.merged()).c_str(),
                     grouped(report.summary.total).c_str());
    }
    return tell(command, report, prints);
}

} // namespace

Result<int> perform(const ResultsCommand& given) {
    const bool is_of_folder = is_folder(given.job);
    const InterruptGuard interrupts(is_of_folder ? InterruptGuard::First::EndsProcess
                                                 : InterruptGuard::First::SetsFlag);
    ResultsCommand command = given;
    keep_each_once(command.formats);
    for (const std::string& format : command.formats) {
        CD_TRY(check_format(format));
    }
    return is_of_folder ? results_of_folder(command) : results_of_job(command);
}

} // namespace cd
