// Runs a job on a master (`run --master`, `submit`): sends it, and fetches its results.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/cluster/fetched_job.hpp"
#include "client/commands/commands.hpp"
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
#include <functional>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// Passes all results of a job in order to a function, and returns a report of them.
using Fetch = std::function<Result<RunReport>(const TakeResult&)>;

Result<int>
report_without_folder(const RunCommand& command, const PreparedJob& job, const Fetch& fetch) {
    auto sink = CD_TRY(ResultSink::open({{}, {}, command.output}, export_context(job)));
    auto report = CD_TRY(fetch([&](const DoneScenario& done) { return sink.add(done.result); }));
    CD_TRY(add_hint(job, report));
    if (!job.query.maps && job.query.level >= Level::Pairs) {
        report.map = sink.map();
    }
    CD_TRY(sink.finish(report.map));
    report.findings = sink.findings();
    return end_run(command, report, sink.uses_stdout());
}

Result<int> report_into_folder(const RunCommand& command,
                               const PreparedJob& job,
                               const Fetch& fetch,
                               FolderRun& run) {
    auto report = CD_TRY(fetch([&](const DoneScenario& done) { return run.add(done); }));
    CD_TRY(add_hint(job, report));
    const std::optional<ContactMap> map = report.map;
    CD_TRY(run.finish(report, command.output, map));
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

/// A job to run on a master.
struct RemoteRun {
    const RunCommand& command;
    PreparedJob& job;
    std::unique_ptr<Connection> connection;
    FolderRun* folder; ///< Null if the job has no output folder.
};

/// Reports the fetched results to the folder, if there is one, and to the user.
Result<int> report(const RemoteRun& run, const Fetch& fetch) {
    return run.folder != nullptr ? report_into_folder(run.command, run.job, fetch, *run.folder)
                                 : report_without_folder(run.command, run.job, fetch);
}

/// Sends `job`, which may be a part of the run's job, watches it to its end, and reports the
/// results that `fetch_from` fetches.
Result<int> run_there(RemoteRun& run,
                      PreparedJob& job,
                      const std::function<Fetch(const JobStatus&)>& fetch_from) {
    const RunCommand& command = run.command;
    std::unique_ptr<Connection>& connection = run.connection;
    const JobId id =
        CD_TRY(send_job(*connection, job, command.quiet, command.master.priority.value_or(0)));
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
    CD_TRY(check_done(watched.value(), text));
    if (run.folder != nullptr) {
        run.folder->set_job(text, worker_count(*connection));
    }
    auto code = report(run, fetch_from(watched.value()));
    if (!code) {
        std::fprintf(stderr,
                     "cdctl: job %s is done; `cdctl results %s` fetches its results\n",
                     text.c_str(),
                     text.c_str());
    }
    return code;
}

/// Runs the whole job.
Result<int> run_whole(RemoteRun& run) {
    return run_there(run, run.job, [&](const JobStatus& status) -> Fetch {
        return [&run, status](const TakeResult& take) {
            return fetch_results(*run.connection, run.job, status, take);
        };
    });
}

/// Returns a job of the scenarios in `poses`, which are some of the job's.
PreparedJob part_of(const PreparedJob& job, std::unique_ptr<PoseSource> poses) {
    PreparedJob part;
    part.spec = job.spec;
    part.spec.name += " (the rest)";
    PoseFileSpec file;
    file.path = "-"; // The part has no pose file of its own.
    part.spec.poses = std::move(file);
    part.names = job.names;
    part.meshes = job.meshes;
    part.query = job.query;
    part.scene = job.scene;
    part.poses = std::move(poses);
    return part;
}

/// Replaces the numbers that scenarios have in the rest by those that they have in the job. Errors:
/// BadFrame for a number that the rest does not have.
Status renumber(PartContacts& contacts, const PoseSubset& rest) {
    for (PartPairContacts& pair : contacts.pairs) {
        for (std::uint64_t* const scenario : {&pair.worst, &pair.first, &pair.last}) {
            if (*scenario >= rest.count()) {
                return Error{ErrorCode::BadFrame, "the sums by part name scenarios of no job"};
            }
            *scenario = rest.index_of(*scenario);
        }
    }
    return Done{};
}

/// Passes reused results, and those of the rest that `fetch_rest` fetches, to `take` in order.
Result<RunReport> fetch_merged(ReusedResults& reused,
                               const PoseSubset& rest,
                               const std::shared_ptr<const BodyPartRuns>& parts,
                               const std::optional<SceneHead>& scene,
                               const Fetch& fetch_rest,
                               const TakeResult& take) {
    ResultMerger merger(reused.scenarios(), scene);
    ContactMapTotal map;
    ReuseMerge merge(
        reused,
        rest,
        0,
        [&](const DoneScenario& done) -> Status {
            static_cast<void>(merger.add(done.result, done.digest));
            if (!done.found.empty()) { // A reused result of a job with maps.
                ContactMapSum sum(parts);
                sum.add(done.result, done.found);
                map.add(sum.take());
            }
            return take(done);
        },
        &InterruptGuard::has_come);
    auto report = CD_TRY(fetch_rest([&](const DoneScenario& done) { return merge.add(done); }));
    CD_TRY(merge.finish());
    report.summary = merger.summary();
    report.digest = merger.digest();
    report.execution.reused = reused.count();
    report.execution.ran = rest.count();
    if (report.map) {
        CD_TRY(renumber(report.map->parts, rest));
        map.add(*report.map);
        report.map = map.map();
    }
    return report;
}

/// Returns the report of a job without scenarios.
RunReport empty_report(const Query& query) {
    RunReport report;
    report.query = query;
    if (query.maps) {
        report.map.emplace();
    }
    return report;
}

/// Runs the scenarios that the earlier run lacks.
Result<int> run_rest(RemoteRun& run, EarlierRun& earlier) {
    auto reused = CD_TRY(earlier.results_for(run.job, run.command.quiet));
    if (run.folder != nullptr) {
        run.folder->set_reused(reused.count());
    }
    auto subset = reused.rest(*run.job.poses, 0);
    const PoseSubset& rest = *subset;
    PreparedJob part = part_of(run.job, std::move(subset));
    // Only jobs of two bodies have maps.
    const auto parts = body_part_runs(*run.job.meshes[0], *run.job.meshes[1]);
    const auto merged = [&](const Fetch& fetch_rest) -> Fetch {
        return [&, fetch_rest](const TakeResult& take) {
            return fetch_merged(reused, rest, parts, scene_head(run.job), fetch_rest, take);
        };
    };
    if (rest.count() == 0) {
        return report(run, merged([&](const TakeResult&) {
                          return Result<RunReport>(empty_report(run.job.query));
                      }));
    }
    return run_there(run, part, [&](const JobStatus& status) -> Fetch {
        return merged([&run, status](const TakeResult& take) {
            return fetch_results(*run.connection, run.job, status, take);
        });
    });
}

} // namespace

Result<int> run_on_master(const RunCommand& command,
                          PreparedJob& job,
                          std::unique_ptr<Connection> connection,
                          EarlierRun* earlier) {
    make_paths_absolute(job);
    RemoteRun run{command, job, std::move(connection), nullptr};
    const auto run_it = [&] {
        return earlier == nullptr ? run_whole(run) : run_rest(run, *earlier);
    };
    if (job.spec.output.dir.empty()) {
        return run_it();
    }
    FolderRunOptions options = folder_options(command.folder, command.master);
    if (earlier != nullptr) {
        options.reused = earlier->named();
    }
    auto folder = CD_TRY(FolderRun::begin(job, std::move(options)));
    if (folder.is_complete()) {
        return tell_complete(command, job, folder);
    }
    run.folder = &folder;
    auto code = run_it();
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
    make_paths_absolute(job);
    print_header(job, command.quiet);
    InterruptGuard::begin_to_flag();
    const JobId id =
        CD_TRY(send_job(*connection, job, command.quiet, command.master.priority.value_or(0)));
    std::fputs(submitted_text(command, job, id).c_str(), stdout);
    return exit_done;
}

} // namespace cd
