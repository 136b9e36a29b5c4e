#include "client/commands/remote_session.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/slow_note.hpp"
#include "client/job/submission.hpp"
#include "client/remote/credential_renewal.hpp"
#include "client/remote/membership.hpp"
#include "client/report/waiting_note.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/words.hpp"
#include "web/status/job_id.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr double bytes_per_megabyte = 1e6;

/// Returns the error for an argument taken for a job's id, since no folder has this name.
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

Result<std::unique_ptr<Connection>> open_again(const MasterOptions& master) {
    const auto give_up_at = std::chrono::steady_clock::now() + timing::come_back_max;
    for (;;) {
        auto opened = open_master(master);
        if (opened || !is_of_the_network(opened.error()) ||
            std::chrono::steady_clock::now() > give_up_at) {
            return opened;
        }
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        std::this_thread::sleep_for(timing::come_back_period);
    }
}

} // namespace

Result<std::unique_ptr<Connection>> open_master(const MasterOptions& options) {
    const Endpoint master = CD_TRY(parse_endpoint(options.address));
    auto tls = CD_TRY(client_tls(options, master));
    auto opened = Connection::open(
        options.address, options.insecure, &InterruptGuard::has_come, std::move(tls));
    if (!opened && opened.error().code == ErrorCode::Disconnected &&
        opened.error().detail.starts_with("cannot connect")) {
        return Error{ErrorCode::Disconnected,
                     opened.error().detail + "; is cdmaster running there?"};
    }
    return opened;
}

Result<std::unique_ptr<Connection>> open_master_for_job(const MasterOptions& options) {
    auto opened = open_master(options);
    if (!opened && opened.error().code == ErrorCode::Disconnected) {
        return Error{ErrorCode::Disconnected,
                     opened.error().detail + " without --master the job runs here"};
    }
    return opened;
}

Result<ConnectedCluster> open_cluster(const MasterOptions& options) {
    auto connection = CD_TRY(open_master(options));
    auto status = CD_TRY(connection->status());
    return ConnectedCluster{std::move(connection), std::move(status)};
}

Result<ConnectedJob> open_job(const MasterOptions& options, const std::string& text) {
    auto [connection, cluster] = CD_TRY(open_cluster(options));
    const JobId id = CD_TRY(find_job(text, cluster.jobs, connection->owner()));
    const auto status = std::ranges::find(cluster.jobs, id, &JobStatus::job);
    return ConnectedJob{std::move(connection), *status, job_id_text(id, ids_of(cluster.jobs))};
}

Result<ConnectedJob> open_job_of_argument(const MasterOptions& options, const std::string& text) {
    auto opened = open_job(options, text);
    return opened ? std::move(opened) : no_folder(text, opened.error());
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

Result<JobStatus> watch_job(const MasterOptions& master,
                            std::unique_ptr<Connection>& connection,
                            JobId job,
                            const std::string& id,
                            ProgressPrinter::Style progress) {
    ProgressPrinter printer(progress);
    int damaged = 0; // Number of consecutive connections with damaged bytes.
    JobStatus last;
    std::optional<ClusterStatus> cluster;
    const auto print = [&] {
        const WaitingNote note =
            cluster ? waiting_note(last, *cluster, master.address) : WaitingNote();
        const ProgressState state{id, last.summary, last.seconds, note};
        if (last.state == JobState::Running) {
            printer.update(state);
        } else {
            printer.finish(state);
        }
    };
    const auto show = [&](const JobStatus& status) {
        damaged = 0;
        last = status;
        print();
    };
    const auto look = [&](const ClusterStatus& status) {
        cluster = status;
        print();
    };
    const bool tells = progress != ProgressPrinter::Style::Silent;
    const CredentialRenewal renewal(master, parse_endpoint(master.address).value());
    std::uint64_t renewals = renewal.count();
    for (;;) {
        Result<JobStatus> status = connection->watch(
            job, show, tells ? look : std::function<void(const ClusterStatus&)>());
        const bool is_renewed = renewal.count() != renewals; // Since the last connection.
        if (!status && status.error().code == ErrorCode::Refused && is_renewed) {
            renewals = renewal.count();
            connection = CD_TRY(open_again(master));
            continue;
        }
        if (status || !is_of_the_network(status.error())) {
            return status;
        }
        // Gives up on a master that sends nothing but damaged bytes.
        if (status.error().code == ErrorCode::BadFrame &&
            ++damaged >= limits::damaged_connections_max) {
            return status;
        }
        std::fprintf(stderr,
                     "cdctl: the master is gone; waiting for it to come back: %s\n",
                     status.error().detail.c_str());
        std::this_thread::sleep_for(timing::come_back_period);
        connection = CD_TRY(open_again(master));
    }
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
