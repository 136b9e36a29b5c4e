// The verbs that show a master and its jobs.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/fetched_job.hpp"
#include "client/commands/remote_session.hpp"
#include "client/report/explain_report.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "web/status/cluster_report.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>

namespace cd {

namespace {

/// Time between the two cluster statuses from which rates and the bottleneck are computed.
constexpr std::chrono::milliseconds sample_time{500};

int print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

/// Reads a job's results for its least distance; nothing if the job does not ask for distances, or
/// has more scenarios than are worth it.
Result<std::optional<LeastDistance>>
least_of(Connection& connection, const JobStatus& status, const Submit& job) {
    std::optional<LeastDistance> least;
    const std::uint64_t scenarios = status.summary.total;
    if (job.query.question == Question::Distance && scenarios <= limits::watch_scenarios_max) {
        CD_TRY(connection.fetch(status.job, 0, scenarios, [&](const ScenarioResult& result) {
            note_least(result, job.unit, least);
            return Status(Done{});
        }));
    }
    return least;
}

} // namespace

Result<int> perform(const WatchCommand& command) {
    const InterruptGuard interrupts;
    auto [connection, known, id] = CD_TRY(open_job(command.master, command.job));
    const auto style = command.only_wait && !command.quiet
                           ? ProgressPrinter::Style::Notes
                           : ProgressPrinter::style_for(command.quiet);
    const Submit job = CD_TRY(connection->job_description(known.job)).submit;
    const JobStatus status = CD_TRY(watch_job(command.master, connection, known.job, id, style));
    if (command.output == "json") {
        print(job_json(status));
    } else if (!command.quiet && !command.only_wait) {
        RunReport report = report_of(status, job.query);
        report.findings.least = CD_TRY(least_of(*connection, status, job));
        print(summary_text(report, {colours_wanted(stdout), command.statistics}));
    }
    CD_TRY(check_done(status, id));
    CD_TRY(check_fail_on(command.fail_on, job.query));
    return exit_code_of(status.summary, command.fail_on);
}

Result<int> perform(const GetCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, status] = CD_TRY(open_cluster(command.master));
    const Table table = command.what == "jobs"      ? jobs_table(status)
                        : command.what == "workers" ? workers_table(status)
                                                    : meshes_table(status);
    return print(format_table(table, command.output));
}

Result<int> perform(const StatusCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, before] = CD_TRY(open_cluster(command.master));
    ClusterStatus after = before;
    if (std::ranges::count(before.jobs, JobState::Running, &JobStatus::state) != 0) {
        CD_TRY(connection->pause(sample_time));
        after = CD_TRY(connection->status());
    }
    return print(command.output == "json" ? status_json(before, after)
                                          : status_text(before, after));
}

Result<int> perform(const ExplainCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, job, id] = CD_TRY(open_job(command.master, command.job));
    const Explained explained = CD_TRY(connection->explain(job.job, command.scenario));
    return print(command.output == "json" ? explained_json(explained, id)
                                          : explained_text(explained, id));
}

Result<int> perform(const CancelCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, job, id] = CD_TRY(open_job(command.master, command.job));
    const JobStatus status =
        CD_TRY(command.scenario ? connection->cancel_scenario(job.job, *command.scenario)
                                : connection->cancel(job.job));
    return print(id + "  " + std::string(to_text(status.state)) + "\n");
}

} // namespace cd
