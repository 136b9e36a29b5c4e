// The verbs that show a master and its jobs.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/cluster/fetched_job.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/export/motion_times.hpp"
#include "client/report/explain_report.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "web/server/scene/scene_rows.hpp"
#include "web/status/cluster_report.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace cd {

namespace {

/// Time between the two cluster statuses from which rates and the bottleneck are computed.
constexpr std::chrono::milliseconds sample_time{500};

int print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

/// Reads a job's results for its least distance.
Result<std::optional<LeastDistance>>
least_of(Connection& connection, const JobStatus& status, const Submit& job) {
    std::optional<LeastDistance> least;
    CD_TRY(connection.fetch(status.job, 0, status.summary.total, [&](const ScenarioResult& result) {
        note_least(result, job.unit, least);
        return Status(Done{});
    }));
    return least;
}

/// Tells the time of an event by the labels of its scenario alone. Times of poses rise, so that the
/// first event by numbers is the first by time.
Result<FirstEvent>
timed_event(Connection& connection, JobId job, const FirstEvent& event, ScenarioResult result) {
    auto read = CD_TRY(connection.fetch_poses(job, event.scenario, 1));
    result.index = 0; // The labels are those of one scenario.
    FirstEvent timed =
        *MotionTimes(std::make_shared<const PoseLabels>(std::move(read.labels))).event(result);
    timed.scenario = event.scenario;
    return timed;
}

/// Reads the results of a job of motions for their first event.
Result<std::optional<FirstEvent>>
first_event_of(Connection& connection, const JobStatus& status, const Submit& job) {
    const auto steps = CD_TRY(steps_of(job));
    const MotionTimes times = steps == nullptr ? MotionTimes() : MotionTimes(steps);
    std::optional<FirstEvent> first;
    ScenarioResult result_of_first;
    CD_TRY(connection.fetch(status.job, 0, status.summary.total, [&](const ScenarioResult& result) {
        const bool had_one = first.has_value();
        keep_first(times.event(result), first);
        if (first && (!had_one || first->scenario == result.index)) {
            result_of_first = result;
        }
        return Status(Done{});
    }));
    if (first && job.poses.labels.has_end_times) {
        first = CD_TRY(timed_event(connection, status.job, *first, result_of_first));
    }
    return first;
}

/// Reads what only the results of a job tell; nothing of one with more scenarios than are worth it.
Result<RunFindings>
findings_of(Connection& connection, const JobStatus& status, const Submit& job) {
    RunFindings findings;
    if (status.summary.total > limits::watch_scenarios_max) {
        return findings;
    }
    if (job.query.question == Question::Distance) {
        findings.least = CD_TRY(least_of(connection, status, job));
    }
    if (job.query.motion) {
        findings.first_event = CD_TRY(first_event_of(connection, status, job));
    }
    return findings;
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
        report.findings = CD_TRY(findings_of(*connection, status, job));
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

Result<int> perform(const PriorityCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, job, id] = CD_TRY(open_job(command.master, command.job));
    const JobStatus status = CD_TRY(connection->set_priority(job.job, command.priority));
    return print(id + "  priority " + std::to_string(status.turn.priority) + "\n");
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
