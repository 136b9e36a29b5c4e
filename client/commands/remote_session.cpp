#include "client/commands/remote_session.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/job_id.hpp"
#include "client/base/slow_note.hpp"
#include "client/base/words.hpp"
#include "client/job/submission.hpp"
#include "client/remote/credential_renewal.hpp"
#include "client/remote/membership.hpp"
#include "client/report/waiting_note.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/timing/client.hpp"
#include "common/job/result/packed_map.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

namespace cd {

namespace {

constexpr double bytes_per_megabyte = 1e6;

std::string mesh_name(const ClusterStatus& status, const Sha256& mesh) {
    const auto found = std::find_if(status.meshes.begin(),
                                    status.meshes.end(),
                                    [&](const MeshStatus& each) { return each.mesh == mesh; });
    return found == status.meshes.end() || found->name.empty() ? to_short_hex(mesh) : found->name;
}

/// True if a new connection may help: the old one broke, was silent, or brought damaged bytes.
bool is_of_the_network(const Error& error) {
    return error.code == ErrorCode::Disconnected || error.code == ErrorCode::Timeout ||
           error.code == ErrorCode::BadFrame;
}

Result<std::unique_ptr<Connection>> open_again(const MasterOptions& master) {
    const auto give_up_at = std::chrono::steady_clock::now() + timing::come_back_max;
    for (;;) {
        auto opened = open_master(master);
        if (opened || !is_of_the_network(opened.error()) ||
            std::chrono::steady_clock::now() > give_up_at) {
            return opened;
        }
        std::this_thread::sleep_for(timing::come_back_period);
    }
}

} // namespace

Result<std::unique_ptr<Connection>> open_master(const MasterOptions& options) {
    const Result<Endpoint> master = parse_endpoint(options.address);
    if (!master) {
        return master.error();
    }
    auto tls = client_tls(options, master.value());
    if (!tls) {
        return tls.error();
    }
    auto opened = Connection::open(
        options.address, options.insecure, &InterruptGuard::has_come, std::move(tls.value()));
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
    auto connection = open_master(options);
    if (!connection) {
        return connection.error();
    }
    auto status = connection.value()->status();
    if (!status) {
        return status.error();
    }
    return ConnectedCluster{std::move(connection.value()), std::move(status.value())};
}

std::uint64_t worker_count(const ClusterStatus& cluster) {
    const auto here = std::ranges::count_if(cluster.workers, [](const WorkerStatus& worker) {
        return worker.state != WorkerState::Lost;
    });
    return static_cast<std::uint64_t>(here);
}

std::string workers_text(const ClusterStatus& cluster) {
    return counted(worker_count(cluster), "worker");
}

Result<JobId> send_job(Connection& connection, PreparedJob& job, bool quiet) {
    const std::array<NamedMesh, 2> meshes{NamedMesh{job.names[0], job.meshes[0]},
                                          NamedMesh{job.names[1], job.meshes[1]}};
    const Status uploaded = connection.upload(
        meshes, [quiet](const NamedMesh& mesh, std::uint64_t bytes, std::uint64_t total) {
            if (!quiet && bytes == 0) {
                std::fprintf(stderr,
                             "  uploading %s, %.1f MB\n",
                             mesh.name.c_str(),
                             static_cast<double>(total) / bytes_per_megabyte);
            }
        });
    if (!uploaded) {
        return uploaded.error();
    }
    Submit submit = submission_of(job);
    if (!job.grid) {
        const SlowNote note("  sending " + counted(submit.scenarios, "pose") + "...", quiet);
        return connection.submit(std::move(submit), *job.poses, job.labels);
    }
    return connection.submit(submit);
}

Result<KnownJob> find_known_job(Connection& connection, const std::string& text) {
    const Result<ClusterStatus> status = connection.status();
    if (!status) {
        return status.error();
    }
    const std::vector<JobId> ids = ids_of(status.value().jobs);
    const Result<JobId> id = find_job(text, status.value().jobs, connection.owner());
    if (!id) {
        return id.error();
    }
    KnownJob known;
    known.id = job_id_text(id.value(), ids);
    for (const JobStatus& job : status.value().jobs) {
        if (job.job == id.value()) {
            known.status = job;
        }
    }
    for (std::size_t body = 0; body < known.bodies.size(); ++body) {
        known.bodies[body] = mesh_name(status.value(), known.status.bodies.at(body));
    }
    return known;
}

Result<JobStatus> watch_job(const MasterOptions& master,
                            std::unique_ptr<Connection>& connection,
                            JobId job,
                            const std::string& id,
                            ProgressPrinter::Style progress) {
    ProgressPrinter printer(progress);
    int damaged = 0; // Number of connections in a row that brought damaged bytes.
    JobStatus last;
    ClusterStatus cluster;
    bool has_looked = false;
    const auto print = [&] {
        const WaitingNote note =
            has_looked ? waiting_note(last, cluster, master.address) : WaitingNote();
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
        has_looked = true;
        print();
    };
    const bool tells = progress != ProgressPrinter::Style::Silent;
    const CredentialRenewal renewal(master, parse_endpoint(master.address).value());
    std::uint64_t renewals = renewal.count();
    for (;;) {
        Result<JobStatus> status = connection->watch(
            job, show, tells ? look : std::function<void(const ClusterStatus&)>());
        if (!status && status.error().code == ErrorCode::Refused && renewal.count() != renewals) {
            // The connection's certificate has expired and has been renewed.
            renewals = renewal.count();
            auto again = open_again(master);
            if (!again) {
                return again.error();
            }
            connection = std::move(again.value());
            continue;
        }
        if (status || !is_of_the_network(status.error())) {
            return status;
        }
        // Gives up on a master that sends only damaged bytes.
        if (status.error().code == ErrorCode::BadFrame &&
            ++damaged >= limits::damaged_connections_max) {
            return status;
        }
        std::fprintf(stderr,
                     "cdctl: the master is gone; waiting for it to come back: %s\n",
                     status.error().detail.c_str());
        std::this_thread::sleep_for(timing::come_back_period);
        auto again = open_again(master);
        if (!again) {
            return again.error();
        }
        connection = std::move(again.value());
    }
}

Status fetch_results(Connection& connection,
                     const JobStatus& job,
                     const std::function<Status(const ScenarioResult&)>& take) {
    // The master uses this merger too, so a result lost or changed in transit changes the digest.
    ResultMerger merger(job.summary.total);
    const Status fetched =
        connection.fetch(job.job, 0, job.summary.total, [&](const ScenarioResult& result) {
            (void)merger.add(result);
            return take(result);
        });
    if (!fetched) {
        return fetched;
    }
    if (job.digest && merger.digest() != job.digest) {
        return Error{ErrorCode::BadFrame, "the received results do not have the job's digest"};
    }
    return Done{};
}

Status fetch_map(Connection& connection, JobId job, RunReport& report) {
    const Result<ContactMapAnswer> answer = connection.contact_map(job);
    if (!answer) {
        return answer.error();
    }
    report.map_withdrawn = answer.value().withdrawn;
    if (!answer.value().is_asked || !report.map_withdrawn.empty()) {
        return Done{};
    }
    // Uses bounds that hold for any mesh, since the meshes need not be loaded here.
    const ContactMapBounds bounds{
        limits::mesh_triangles_max, limits::mesh_triangles_max, report.summary.total};
    Result<ContactMap> map = unpack_map(answer.value().map, bounds);
    if (!map) {
        return map.error();
    }
    report.map = std::move(map.value());
    return Done{};
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

std::string coverage_text(const JobStatus& job, std::uint64_t answered) {
    if (job.state == JobState::Done) {
        return "";
    }
    return "incomplete: " + grouped(answered) + " of " + grouped(job.summary.total) +
           " scenarios have a result; the job is " + std::string(to_text(job.state)) +
           (job.failure.empty() || job.state != JobState::Failed ? "" : ": " + job.failure);
}

RunReport report_of(const JobStatus& job, Level level) {
    RunReport report;
    report.summary = job.summary;
    report.level = level;
    report.digest = job.digest;
    report.execution.seconds = job.seconds;
    report.execution.statistics = job.statistics;
    report.execution.traffic = job.traffic;
    report.execution.depths = job.depths;
    return report;
}

} // namespace cd
