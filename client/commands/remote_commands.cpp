// The verbs that show a master and its jobs.
#include "client/commands/remote_commands.hpp"

#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/report/cluster_report.hpp"
#include "client/report/explain_report.hpp"

#include <cstdio>

namespace cd {

namespace {

/// Time between the two cluster statuses from which rates and the bottleneck are computed.
constexpr std::chrono::milliseconds sample_time{500};

/// Guesses the level, which a job's status lacks: only `level any` finds the class `contact`.
Level level_of(const Summary& summary) {
    return summary.contact != 0 ? Level::Any : Level::Pairs;
}

struct Statuses {
    ClusterStatus before;
    ClusterStatus after;
};

/// Gets two statuses, `sample_time` apart if a job is running.
Result<Statuses> sample(Connection& connection) {
    const Result<ClusterStatus> before = connection.status();
    if (!before) {
        return before.error();
    }
    bool running = false;
    for (const JobStatus& job : before.value().jobs) {
        running = running || job.state == JobState::Running;
    }
    if (!running) {
        return Statuses{before.value(), before.value()};
    }
    if (const Status paused = connection.pause(sample_time); !paused) {
        return paused.error();
    }
    const Result<ClusterStatus> after = connection.status();
    if (!after) {
        return after.error();
    }
    return Statuses{before.value(), after.value()};
}

} // namespace

int execute(const WatchCommand& command) {
    const InterruptGuard interrupts;
    auto connection = open_master(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    const Result<KnownJob> job = find_known_job(*connection.value(), command.job);
    if (!job) {
        return fail(job.error());
    }
    const auto style = command.only_wait && !command.quiet
                           ? ProgressPrinter::Style::Notes
                           : ProgressPrinter::style_for(command.quiet);
    const auto status = watch_job(
        command.master, connection.value(), job.value().status.job, job.value().id, style);
    if (!status) {
        return fail(status.error());
    }
    const Level level = level_of(status.value().summary);
    if (command.output == "json") {
        std::fputs(job_json(status.value()).c_str(), stdout);
    } else if (!command.quiet && !command.only_wait) {
        const RunReport report = report_of(status.value(), level);
        std::fputs(summary_text(report, {colours_wanted(stdout), command.statistics}).c_str(),
                   stdout);
    }
    if (const Status done = check_done(status.value(), job.value().id); !done) {
        return fail(done.error());
    }
    if (const Status answerable = check_fail_on(command.fail_on, level); !answerable) {
        return fail(answerable.error());
    }
    return exit_code_of(status.value().summary, command.fail_on);
}

int execute(const GetCommand& command) {
    const InterruptGuard interrupts;
    const auto cluster = open_cluster(command.master);
    if (!cluster) {
        return fail(cluster.error());
    }
    const auto& [connection, status] = cluster.value();
    const Table table = command.what == "jobs"      ? jobs_table(status)
                        : command.what == "workers" ? workers_table(status)
                                                    : meshes_table(status);
    std::fputs(format_table(table, command.output).c_str(), stdout);
    return exit_done;
}

int execute(const StatusCommand& command) {
    const InterruptGuard interrupts;
    auto connection = open_master(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    const Result<Statuses> statuses = sample(*connection.value());
    if (!statuses) {
        return fail(statuses.error());
    }
    const auto& [before, after] = statuses.value();
    const bool json = command.output == "json";
    std::fputs((json ? status_json(before, after) : status_text(before, after)).c_str(), stdout);
    return exit_done;
}

int execute(const ExplainCommand& command) {
    const InterruptGuard interrupts;
    auto connection = open_master(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    const Result<KnownJob> job = find_known_job(*connection.value(), command.job);
    if (!job) {
        return fail(job.error());
    }
    const Result<Explained> explained =
        connection.value()->explain(job.value().status.job, command.scenario);
    if (!explained) {
        return fail(explained.error());
    }
    const bool json = command.output == "json";
    const std::string text = json ? explained_json(explained.value(), job.value().id)
                                  : explained_text(explained.value(), job.value().id);
    std::fputs(text.c_str(), stdout);
    return exit_done;
}

int execute(const CancelCommand& command) {
    const InterruptGuard interrupts;
    auto connection = open_master(command.master);
    if (!connection) {
        return fail(connection.error());
    }
    const Result<KnownJob> job = find_known_job(*connection.value(), command.job);
    if (!job) {
        return fail(job.error());
    }
    const JobId id = job.value().status.job;
    const auto status = command.scenario
                            ? connection.value()->cancel_scenario(id, *command.scenario)
                            : connection.value()->cancel(id);
    if (!status) {
        return fail(status.error());
    }
    std::printf(
        "%s  %s\n", job.value().id.c_str(), std::string(to_text(status.value().state)).c_str());
    return exit_done;
}

} // namespace cd
