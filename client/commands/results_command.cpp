// The verb `results`, for a results folder or a job on a master.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/words.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/run_command.hpp"
#include "client/export/result_sink.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/kept_summary.hpp"
#include "client/folder/opened_run.hpp"
#include "client/formats/output_file.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// The exit code of a job: contacts are no failure here, missing results are.
int exit_code_of_job(const KnownJob& job) {
    return job.status.state == JobState::Done ? exit_code_of(job.status.summary, FailOn::Never)
                                              : exit_incomplete;
}

/// Prints the summary, unless `prints`: then the results themselves are printed as text.
Status tell(const ResultsCommand& command, const RunReport& report, bool prints) {
    return prints
               ? Status(Done{})
               : print_summary(report, command.output != "text", command.quiet, command.statistics);
}

int results_of_job(const ResultsCommand& command) {
    auto job = FetchedJob::open(command.master, command.job, tree_cache_folder(command.tree_cache));
    if (!job) {
        return fail(job.error());
    }
    PreparedJob& prepared = job.value().prepared();
    prepared.spec.output.dir = command.out;
    prepared.spec.output.exact_points = command.exact_points;
    if (!command.formats.empty()) {
        prepared.spec.output.formats = command.formats;
    }
    const bool prints = command.out.empty() && command.output == "text";
    auto report =
        command.out.empty()
            ? job.value().print(prints ? "records-text" : command.output)
            : job.value().write(folder_options(command.folder, command.master), command.output);
    if (!report) {
        return fail(report.error());
    }
    const std::string coverage = job.value().coverage();
    if (!coverage.empty()) {
        std::fprintf(stderr, "cdctl: %s\n", coverage.c_str());
    }
    const Status told = tell(command, report.value(), prints);
    return told ? exit_code_of_job(job.value().known()) : fail(told.error());
}

/// Prints the summary.json of a folder that an earlier version wrote without records. Fails with
/// `no_run` if the command needs records.
int results_of_summary(const ResultsCommand& command, const Error& no_run) {
    if (!command.formats.empty() || command.output == "csv") {
        return fail(no_run);
    }
    const fs::path path = fs::path(command.job) / "summary.json";
    const auto report = read_summary(path);
    if (!report) {
        return fail(report.error());
    }
    OutputFile out = OutputFile::standard_output();
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    const Status written =
        command.output == "json"
            ? out.write(text.str())
            : out.write(summary_text(report.value(), {colours_wanted(stdout), false}));
    const Status told = written ? out.commit() : written;
    return told ? exit_code_of(report.value().summary, FailOn::Never) : fail(told.error());
}

/// Writes the results of a folder into it in the given formats. Without formats, the results go to
/// stdout, and no file is written.
int results_of_folder(const ResultsCommand& command) {
    if (!command.out.empty()) {
        return fail({ErrorCode::BadInput,
                     "formats of a folder are written into it; leave out --out, or copy the "
                     "folder first"});
    }
    auto run = OpenedRun::open(command.job);
    if (!run) {
        return holds_only_a_summary(command.job) ? results_of_summary(command, run.error())
                                                 : fail(run.error());
    }
    auto context = export_context(run.value());
    if (!context) {
        return fail(context.error());
    }
    context.value().exact_points = command.exact_points;
    InterruptGuard::begin_to_flag(); // A signal must not leave partial files.
    std::optional<RunFolder> folder;
    if (!command.formats.empty()) {
        auto opened = RunFolder::open_finished(run.value().dir(), run.value().manifest());
        if (!opened) {
            return fail(opened.error());
        }
        folder.emplace(std::move(opened.value()));
    }
    const bool prints = command.formats.empty() && command.output == "text";
    const auto report =
        add_exports(run.value(),
                    folder ? &*folder : nullptr,
                    context.value(),
                    {command.formats, prints ? "records-text" : command.output, true});
    if (!report) {
        return fail(report.error());
    }
    const Summary& summary = report.value().summary;
    if (!summary.is_complete()) {
        std::fprintf(stderr,
                     "cdctl: incomplete: %s of %s scenarios have a result\n",
                     grouped(summary.merged()).c_str(),
                     grouped(summary.total).c_str());
    }
    const Status told = tell(command, report.value(), prints);
    return told ? exit_code_of(summary, FailOn::Never) : fail(told.error());
}

} // namespace

int execute(const ResultsCommand& given) {
    const bool is_of_folder = is_folder(given.job);
    const InterruptGuard interrupts(is_of_folder ? InterruptGuard::First::EndsProcess
                                                 : InterruptGuard::First::SetsFlag);
    ResultsCommand command = given;
    keep_each_once(command.formats);
    for (const std::string& format : command.formats) {
        if (Status known = check_format(format); !known) {
            return fail(known.error());
        }
    }
    return is_of_folder ? results_of_folder(command) : results_of_job(command);
}

} // namespace cd
