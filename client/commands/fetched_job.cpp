#include "client/commands/fetched_job.hpp"

#include "client/base/words.hpp"
#include "client/export/result_sink.hpp"
#include "client/job/submission.hpp"

#include <algorithm>
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
        auto poses = connection_.fetch_poses(job_, first, count);
        return poses ? Result<std::vector<Scenario>>(std::move(poses.value().scenarios))
                     : poses.error();
    }

  private:
    Connection& connection_;
    JobId job_;
    std::uint64_t count_;
};

/// The mesh from the cache, or else from the master. Errors: those of the connection.
Result<std::shared_ptr<const Mesh>>
get_mesh(Connection& connection, const Sha256& mesh, const MeshCache& cache) {
    if (auto kept = cache.find(mesh)) {
        return kept;
    }
    auto fetched = connection.fetch_mesh(mesh);
    if (!fetched) {
        return fetched.error();
    }
    cache.keep(fetched.value());
    return std::make_shared<const Mesh>(std::move(fetched.value()));
}

Status get_meshes(Connection& connection,
                  const Submit& submit,
                  const MeshCache& cache,
                  JobInputs& inputs) {
    for (std::size_t i = 0; i < inputs.meshes.size(); ++i) {
        if (i == 1 && submit.bodies.at(1).mesh == submit.bodies.at(0).mesh) {
            inputs.meshes[1] = inputs.meshes[0];
            continue;
        }
        auto mesh = get_mesh(connection, submit.bodies.at(i).mesh, cache);
        if (!mesh) {
            return mesh.error();
        }
        inputs.meshes[i] = std::move(mesh.value());
    }
    return Done{};
}

/// The error for an argument that was taken for a job's id, since no folder has this name.
Error no_folder(const std::string& text, const Error& error) {
    const std::string detail = "there is no folder '" + text + "', ";
    switch (error.code) {
    case ErrorCode::Disconnected:
        return {error.code,
                detail + "so it was taken as a job of the master: " + error.detail +
                    " --master names another one"};
    case ErrorCode::NotFound:
        return {error.code, detail + "and " + error.detail};
    default:
        return error;
    }
}

} // namespace

Result<RunReport>
fetched_report(Connection& connection, const Query& query, const JobStatus& status) {
    RunReport report = report_of(status, query.level);
    report.limit_pairs = query.limit_pairs;
    report.maps_all_pairs = query.maps;
    const Result<ClusterStatus> cluster = connection.status();
    report.execution.where = cluster ? workers_text(cluster.value()) : std::string();
    if (query.maps && status.state == JobState::Done) {
        if (Status map = fetch_map(connection, status.job, report); !map) {
            return map.error();
        }
    }
    return report;
}

Result<FetchedJob> FetchedJob::open(const MasterOptions& master,
                                    const std::string& text,
                                    const std::filesystem::path& tree_cache) {
    auto connection = open_master(master);
    if (!connection) {
        return no_folder(text, connection.error());
    }
    auto known = find_known_job(*connection.value(), text);
    if (!known) {
        return no_folder(text, known.error());
    }
    FetchedJob job(std::move(connection.value()), std::move(known.value()));
    if (Status prepared = job.prepare(MeshCache(tree_cache)); !prepared) {
        return prepared.error();
    }
    return job;
}

Status FetchedJob::prepare(const MeshCache& meshes) {
    const JobId id = known_.status.job;
    const auto described = connection_->job_description(id);
    if (!described) {
        return described.error();
    }
    const Submit& submit = described.value().submit;
    auto spec = spec_of(submit);
    if (!spec) {
        return spec.error();
    }
    JobInputs inputs;
    if (Status fetched = get_meshes(*connection_, submit, meshes, inputs); !fetched) {
        return fetched;
    }
    labels_ = submit.poses.labels;
    if (!submit.grid) {
        inputs.poses = std::make_unique<RemotePoses>(*connection_, id, submit.scenarios);
    }
    inputs.ignored = submit.query.ignored;
    ThreadPool pool(1);
    TreeCache cache{std::filesystem::path()};
    auto job = prepare_job(
        std::move(spec.value()), Trees::ForPosesOnly, cache, pool, true, std::move(inputs));
    if (!job) {
        return job.error();
    }
    prepared_ = std::make_unique<PreparedJob>(std::move(job.value()));
    return Done{};
}

Result<RunReport> FetchedJob::make_report() {
    return fetched_report(*connection_, prepared_->query, known_.status);
}

Result<RunReport> FetchedJob::print(const std::string& output) {
    auto sink = ResultSink::open({{}, {}, output}, export_context(*prepared_));
    if (!sink) {
        return sink.error();
    }
    const Status fetched = fetch_results(*connection_, known_.status, [&](const auto& result) {
        ++fetched_;
        return sink.value().add(result);
    });
    if (!fetched) {
        return fetched.error();
    }
    if (Status finished = sink.value().finish(std::nullopt); !finished) {
        return finished.error();
    }
    auto report = make_report();
    if (report) {
        report.value().most_touched = sink.value().tally().most_touched();
    }
    return report;
}

Status FetchedJob::fetch_labels() {
    if (labels_.is_empty()) {
        return Done{};
    }
    const std::uint64_t count = prepared_->poses->count();
    for (std::uint64_t first = 0; first < count; first += poses_at_once) {
        const auto poses = connection_->fetch_poses(
            known_.status.job, first, std::min(poses_at_once, count - first));
        if (!poses) {
            return poses.error();
        }
        prepared_->labels.append(poses.value().labels);
    }
    return labels_.fit(prepared_->labels, count)
               ? Status(Done{})
               : Error{ErrorCode::BadFrame, "the job has other ids or times than it announced"};
}

Result<RunReport> FetchedJob::write(FolderRunOptions options, const std::string& output) {
    if (Status fetched = fetch_labels(); !fetched) {
        return fetched.error();
    }
    options.where.job = known_.id;
    const auto cluster = connection_->status();
    options.where.workers = cluster ? worker_count(cluster.value()) : 0;
    const JobStatus& job = known_.status;
    options.started = iso_time(job.began);
    options.ended = iso_time(job.began + static_cast<std::uint64_t>(std::max(0.0, job.seconds)));
    options.folder.fresh = true; // A running job may have more results by now.
    auto run = FolderRun::begin(*prepared_, std::move(options));
    if (!run) {
        return run.error();
    }
    auto report = write_into(run.value(), output);
    run.value().drop_unfinished();
    return report;
}

Result<RunReport> FetchedJob::write_into(FolderRun& run, const std::string& output) {
    const Status fetched =
        fetch_results(*connection_, known_.status, [&](const ScenarioResult& result) {
            ++fetched_;
            return run.add({result, encode_result(result), {}, {}});
        });
    if (!fetched) {
        return fetched.error();
    }
    auto report = make_report();
    if (!report) {
        return report;
    }
    const std::optional<ContactMap> map = report.value().map;
    if (Status finished = run.finish(report.value(), output, map); !finished) {
        return finished.error();
    }
    return report;
}

} // namespace cd
