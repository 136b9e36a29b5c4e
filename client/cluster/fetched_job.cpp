#include "client/cluster/fetched_job.hpp"

#include "client/export/result_sink.hpp"
#include "client/job/submission.hpp"
#include "client/remote/mesh_cache.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/packed_map.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace cd {

namespace {

constexpr std::uint64_t poses_at_once = 1u << 16;

/// The poses of a job on a master. Each `read` fetches the poses from the master.
class RemotePoses final : public PoseSource {
  public:
    RemotePoses(Connection& connection, JobId job, std::uint64_t count)
        : connection_(connection), job_(job), count_(count) {}

    [[nodiscard]] std::uint64_t count() const override { return count_; }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        auto poses = CD_TRY(connection_.fetch_poses(job_, first, count));
        return std::move(poses.scenarios);
    }

  private:
    Connection& connection_;
    JobId job_;
    std::uint64_t count_;
};

/// Passes all existing results of a job to `take`, and returns their number. Errors: from `take`;
/// BadFrame if the results do not match the digest that the master states.
Result<std::uint64_t> fetch_each(Connection& connection,
                                 const JobStatus& job,
                                 const std::optional<SceneHead>& scene,
                                 const TakeResult& take) {
    // The master merges likewise, so a result lost or changed in transit changes the digest.
    ResultMerger merger(job.summary.total, scene);
    CD_TRY(connection.fetch(job.job, 0, job.summary.total, [&](const ScenarioResult& result) {
        const DoneScenario done = done_scenario(result, {});
        static_cast<void>(merger.add(done.result, done.digest));
        return take(done);
    }));
    if (job.digest && merger.digest() != job.digest) {
        return Error{ErrorCode::BadFrame, "the received results do not have the job's digest"};
    }
    return merger.summary().merged();
}

/// Adds a job's contact map, if the job asks for maps, to its report. Errors: BadFrame for an
/// invalid map; the connection's.
Status fetch_map(Connection& connection, JobId job, RunReport& report) {
    const ContactMapAnswer answer = CD_TRY(connection.contact_map({job}));
    report.map_withdrawn = answer.withdrawn;
    if (answer.is_asked && report.map_withdrawn.empty()) {
        // Checks the map against the largest allowed mesh, since the meshes may not be loaded.
        report.map = CD_TRY(unpack_map(answer.map, any_map(report.summary.total)));
    }
    return Done{};
}

/// Makes the report of a job whose results were fetched, with the map if the master summed one.
Result<RunReport> fetched_report(Connection& connection,
                                 const Query& query,
                                 const JobStatus& status,
                                 std::uint64_t fetched) {
    RunReport report = report_of(status, query);
    report.execution.where = workers_text(connection);
    report.execution.fetched = fetched;
    if (query.maps && status.state == JobState::Done) {
        CD_TRY(fetch_map(connection, status.job, report));
    }
    return report;
}

} // namespace

RunReport report_of(const JobStatus& job, const Query& query) {
    RunReport report;
    report.summary = job.summary;
    report.query = query;
    report.digest = job.digest;
    report.execution.seconds = job.seconds;
    report.execution.statistics = job.statistics;
    report.execution.traffic = job.traffic;
    report.execution.depths = job.depths;
    return report;
}

Result<RunReport> fetch_results(Connection& connection,
                                const PreparedJob& job,
                                const JobStatus& status,
                                const TakeResult& take) {
    const std::uint64_t fetched = CD_TRY(fetch_each(connection, status, scene_head(job), take));
    return fetched_report(connection, job.query, status, fetched);
}

Result<FetchedJob> FetchedJob::open(ConnectedJob connected,
                                    const std::filesystem::path& tree_cache) {
    FetchedJob job(std::move(connected));
    CD_TRY(job.prepare(tree_cache));
    return job;
}

Status FetchedJob::prepare(const std::filesystem::path& tree_cache) {
    Connection& connection = *job_.connection;
    const auto [id, began, submit] = CD_TRY(connection.job_description(job_.status.job));
    auto spec = CD_TRY(spec_of(submit));
    labels_ = submit.poses.labels;
    JobInputs inputs;
    const MeshCache meshes(tree_cache);
    std::map<Sha256, std::shared_ptr<const Mesh>> known;
    for (const JobBody& body : submit.bodies) {
        std::shared_ptr<const Mesh>& mesh = known[body.mesh];
        if (mesh == nullptr) {
            mesh = CD_TRY(get_mesh(connection, body.mesh, meshes));
        }
        inputs.meshes.push_back(mesh);
    }
    if (!submit.grid) {
        inputs.poses = std::make_unique<RemotePoses>(connection, id, submit.scenarios);
    }
    inputs.ignored = submit.query.ignored;
    if (submit.poses.scene) {
        inputs.scene = CD_TRY(scene_of(
            submit.bodies, submit.poses.scene->steps, submit.scenarios, submit.poses.scene->head));
        for (const JobBody& body : submit.bodies) {
            inputs.names.push_back(body.name);
        }
    }
    ThreadPool pool(1);
    TreeCache cache{std::filesystem::path()};
    auto job = CD_TRY(
        prepare_job(std::move(spec), Trees::ForPosesOnly, cache, pool, true, std::move(inputs)));
    prepared_ = std::make_unique<PreparedJob>(std::move(job));
    return Done{};
}

Result<RunReport> FetchedJob::fetch(const TakeResult& take) {
    return fetch_results(*job_.connection, *prepared_, job_.status, take);
}

Result<RunReport> FetchedJob::print(const std::string& output) {
    auto sink = CD_TRY(ResultSink::open({{}, {}, output}, export_context(*prepared_)));
    auto report = CD_TRY(fetch([&](const DoneScenario& done) { return sink.add(done.result); }));
    CD_TRY(sink.finish(report.map));
    report.findings = sink.findings();
    return report;
}

Status FetchedJob::fetch_labels() {
    if (labels_.is_empty()) {
        return Done{};
    }
    const std::uint64_t count = prepared_->poses->count();
    for (std::uint64_t first = 0; first < count; first += poses_at_once) {
        const auto poses = CD_TRY(job_.connection->fetch_poses(
            job_.status.job, first, std::min(poses_at_once, count - first)));
        prepared_->labels.append(poses.labels);
    }
    return labels_.fit(prepared_->labels, count)
               ? Status(Done{})
               : Error{ErrorCode::BadFrame, "the job has other ids or times than it announced"};
}

Result<RunReport> FetchedJob::fetch_into(FolderRun& run, const std::string& output) {
    auto report = CD_TRY(fetch([&](const DoneScenario& done) { return run.add(done); }));
    const std::optional<ContactMap> map = report.map;
    CD_TRY(run.finish(report, output, map));
    return report;
}

Result<RunReport> FetchedJob::write(FolderRunOptions options, const std::string& output) {
    CD_TRY(fetch_labels());
    const JobStatus& job = job_.status;
    options.where.job = job_.id;
    options.where.workers = worker_count(*job_.connection);
    options.started = iso_time(job.began);
    options.ended = iso_time(job.began + static_cast<std::uint64_t>(std::max(0.0, job.seconds)));
    options.folder.fresh = true; // A running job may have more results by now.
    auto run = CD_TRY(FolderRun::begin(*prepared_, std::move(options)));
    auto report = fetch_into(run, output);
    run.drop_unfinished();
    return report;
}

} // namespace cd
