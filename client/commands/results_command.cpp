// The verb `results`: of a folder, or of a job on a master.
#include "client/commands/commands.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/run_command.hpp"
#include "client/exit_code.hpp"
#include "client/folder/folder_exports.hpp"
#include "client/folder/opened_run.hpp"
#include "client/interrupt.hpp"

#include <cstdio>

namespace cd {

namespace {

/// What has not been answered is no contact, and no failure of this command.
int exit_code_of_job(const KnownJob& job) {
    return job.status.state == JobState::Done ? exit_code_of(job.status.summary, FailOn::Never)
                                              : exit_incomplete;
}

int results_of_job(const ResultsCommand& command) {
    auto job = FetchedJob::open(command.master, command.job);
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
    const bool stdout_is_used = command.output != "text";
    const Status told = stdout_is_used || prints
                            ? Status(Done{})
                            : print_summary(report.value(), false, false, command.statistics);
    return told ? exit_code_of_job(job.value().known()) : fail(told.error());
}

/// Without formats the results go to stdout.
int results_of_folder(const ResultsCommand& command) {
    if (!command.out.empty()) {
        return fail({ErrorCode::BadInput,
                     "formats of a folder are written into it; leave out --out, or copy the "
                     "folder first"});
    }
    auto run = OpenedRun::open(command.job);
    if (!run) {
        return fail(run.error());
    }
    auto context = export_context(run.value());
    if (!context) {
        return fail(context.error());
    }
    context.value().exact_points = command.exact_points;
    auto folder = RunFolder::open_finished(run.value().dir());
    if (!folder) {
        return fail(folder.error());
    }
    const bool prints = command.formats.empty() && command.output == "text";
    const auto summary =
        add_exports(run.value(),
                    folder.value(),
                    context.value(),
                    {command.formats, prints ? "records-text" : command.output, true});
    if (!summary) {
        return fail(summary.error());
    }
    return exit_code_of(summary.value(), FailOn::Never);
}

} // namespace

int execute(const ResultsCommand& given) {
    const InterruptGuard interrupts;
    ResultsCommand command = given;
    keep_each_once(command.formats);
    for (const std::string& format : command.formats) {
        if (Status known = check_format(format); !known) {
            return fail(known.error());
        }
    }
    return is_folder(command.job) ? results_of_folder(command) : results_of_job(command);
}

} // namespace cd
