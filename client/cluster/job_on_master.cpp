#include "client/cluster/job_on_master.hpp"

#include "client/base/slow_note.hpp"
#include "client/job/submission.hpp"
#include "client/remote/membership.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"
#include "web/status/job_id.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr double bytes_per_megabyte = 1e6;

} // namespace

Result<std::unique_ptr<Connection>> open_master(const MasterOptions& options, StopCheck stopped) {
    const Endpoint master = CD_TRY(parse_endpoint(options.address));
    auto tls = CD_TRY(client_tls(options, master));
    auto opened =
        Connection::open(options.address, options.insecure, std::move(stopped), std::move(tls));
    if (!opened && opened.error().code == ErrorCode::Disconnected &&
        opened.error().detail.starts_with("cannot connect")) {
        return Error{ErrorCode::Disconnected,
                     opened.error().detail + "; is cdmaster running there?"};
    }
    return opened;
}

Result<ConnectedCluster> open_cluster(const MasterOptions& options, StopCheck stopped) {
    auto connection = CD_TRY(open_master(options, std::move(stopped)));
    auto status = CD_TRY(connection->status());
    return ConnectedCluster{std::move(connection), std::move(status)};
}

Result<ConnectedJob>
open_job(const MasterOptions& options, const std::string& text, StopCheck stopped) {
    auto [connection, cluster] = CD_TRY(open_cluster(options, std::move(stopped)));
    const JobId id = CD_TRY(find_job(text, cluster.jobs, connection->owner()));
    const auto status = std::ranges::find(cluster.jobs, id, &JobStatus::job);
    return ConnectedJob{std::move(connection), *status, job_id_text(id, ids_of(cluster.jobs))};
}

std::uint64_t worker_count(const ClusterStatus& cluster) {
    const auto lost = std::ranges::count(cluster.workers, WorkerState::Lost, &WorkerStatus::state);
    return cluster.workers.size() - static_cast<std::uint64_t>(lost);
}

std::uint64_t worker_count(Connection& connection) {
    const auto cluster = connection.status();
    return cluster ? worker_count(cluster.value()) : 0;
}

std::string workers_text(Connection& connection) {
    const auto cluster = connection.status();
    return cluster ? counted(worker_count(cluster.value()), "worker") : "";
}

Result<JobId>
send_job(Connection& connection, PreparedJob& job, bool quiet, std::int32_t priority) {
    std::vector<NamedMesh> meshes;
    std::set<Sha256> known;
    for (std::size_t body = 0; body < job.meshes.size(); ++body) {
        if (known.insert(job.meshes[body]->hash()).second) {
            meshes.push_back({job.names[body], job.meshes[body]});
        }
    }
    CD_TRY(connection.upload(
        meshes, [quiet](const NamedMesh& mesh, std::uint64_t bytes, std::uint64_t total) {
            if (!quiet && bytes == 0) {
                std::fprintf(stderr,
                             "  uploading %s, %.1f MB\n",
                             mesh.name.c_str(),
                             static_cast<double>(total) / bytes_per_megabyte);
            }
        }));
    Submit submit = submission_of(job);
    submit.priority = priority;
    if (job.grid) {
        return connection.submit(submit);
    }
    const SlowNote note("  sending " + counted(submit.scenarios, "pose") + "...", quiet);
    return connection.submit(std::move(submit), *job.poses, job.labels);
}

Status check_done(const JobStatus& job, const std::string& id) {
    const std::string done =
        " (" + grouped(job.summary.merged()) + " of " + grouped(job.summary.total) + " done)";
    switch (job.state) {
    case JobState::Done:
        return Done{};
    case JobState::Running:
        return Error{ErrorCode::Incomplete,
                     "job " + id + " is still running" + done + "; `cdctl wait " + id +
                         "` waits for it"};
    case JobState::Cancelled:
        return Error{ErrorCode::Incomplete, "job " + id + " was cancelled" + done};
    case JobState::Failed:
        return Error{ErrorCode::Incomplete, "job " + id + " failed" + done + ": " + job.failure};
    }
    return Error{ErrorCode::BadFrame, "job " + id + " is in a state that is not known here"};
}

} // namespace cd
