// The verbs that maintain a cluster: removing jobs and meshes, draining workers.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/base/job_id.hpp"
#include "client/base/table.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_commands.hpp"
#include "client/commands/remote_session.hpp"
#include "client/report/cluster_report.hpp"

#include <cstdio>
#include <string>
#include <variant>
#include <vector>

namespace cd {

namespace {

/// A job or mesh that `rm` removes, and its name in messages.
struct Removable {
    std::variant<JobId, Sha256> what;
    std::string name;
};

/// Finds a job by its id, or a mesh by the first four or more digits of its hash. Errors: NotFound;
/// BadInput for an ambiguous prefix.
Result<Removable>
find_removable(const ClusterStatus& status, const std::string& text, const std::string& owner) {
    const Result<JobId> job = find_job(text, status.jobs, owner);
    if (job) {
        return Removable{job.value(), "job " + job_id_text(job.value(), ids_of(status.jobs))};
    }
    std::vector<const MeshStatus*> meshes;
    for (const MeshStatus& mesh : status.meshes) {
        if (text.size() >= 4 && to_hex(mesh.mesh).starts_with(text)) {
            meshes.push_back(&mesh);
        }
    }
    if (meshes.size() > 1) {
        return Error{ErrorCode::BadInput,
                     std::to_string(meshes.size()) + " meshes begin with '" + text + "'"};
    }
    if (meshes.size() == 1 && job.error().code == ErrorCode::NotFound) {
        return Removable{meshes.front()->mesh,
                         "mesh " + to_short_hex(meshes.front()->mesh) + " " + meshes.front()->name};
    }
    return job.error();
}

Result<Removed> remove(Connection& connection, const Removable& target, bool cancel) {
    const auto* job = std::get_if<JobId>(&target.what);
    return job != nullptr ? connection.remove_job(*job, cancel)
                          : connection.remove_mesh(std::get<Sha256>(target.what));
}

/// Finds a worker that is not lost by its id ("w-3") or name. Errors: NotFound; BadInput for an
/// ambiguous name.
Result<WorkerId> find_worker(const ClusterStatus& status, const std::string& text) {
    std::vector<WorkerId> named;
    for (const WorkerStatus& worker : status.workers) {
        if (worker.state == WorkerState::Lost) {
            continue;
        }
        if (text == "w-" + std::to_string(worker.worker.value)) {
            return worker.worker;
        }
        if (text == worker.name) {
            named.push_back(worker.worker);
        }
    }
    if (named.size() > 1) {
        return Error{ErrorCode::BadInput,
                     std::to_string(named.size()) + " workers are called '" + text +
                         "'; name one by its id, see `cdctl get workers`"};
    }
    if (named.empty()) {
        return Error{ErrorCode::NotFound,
                     "no worker '" + text + "' is here; see `cdctl get workers`"};
    }
    return named.front();
}

} // namespace

int execute(const RemoveCommand& command) {
    const InterruptGuard interrupts;
    const auto cluster = open_cluster(command.master);
    if (!cluster) {
        return fail(cluster.error());
    }
    const auto& [connection, status] = cluster.value();
    std::vector<Removable> targets;
    for (const std::string& text : command.what) {
        Result<Removable> target = find_removable(status, text, connection->owner());
        if (!target) {
            return fail(target.error());
        }
        targets.push_back(std::move(target.value()));
    }
    if (!command.yes) {
        for (const Removable& target : targets) {
            std::fprintf(stderr, "cdctl: %s would be removed for good\n", target.name.c_str());
        }
        return fail({ErrorCode::BadInput, "nothing was removed; add --yes"});
    }
    for (const Removable& target : targets) {
        const Result<Removed> removed = remove(*connection, target, command.cancel);
        if (!removed) {
            return fail({removed.error().code, target.name + ": " + removed.error().detail});
        }
        std::printf("%s removed, %s freed\n",
                    target.name.c_str(),
                    cell_text(removed.value().bytes, CellKind::Size).c_str());
    }
    return exit_done;
}

int execute(const DrainCommand& command) {
    if (command.all == !command.workers.empty()) {
        return fail({ErrorCode::BadInput, "name the workers to drain, or say --all"});
    }
    const InterruptGuard interrupts;
    const auto cluster = open_cluster(command.master);
    if (!cluster) {
        return fail(cluster.error());
    }
    const auto& [connection, status] = cluster.value();
    DrainWorkers wish;
    wish.now = command.now;
    for (const std::string& text : command.workers) {
        const Result<WorkerId> worker = find_worker(status, text);
        if (!worker) {
            return fail(worker.error());
        }
        wish.workers.push_back(worker.value());
    }
    const Result<Draining> told = connection->drain(wish);
    if (!told) {
        return fail(told.error());
    }
    for (const WorkerId worker : told.value().workers) {
        std::printf("w-%llu %s\n",
                    static_cast<unsigned long long>(worker.value),
                    command.now ? "ends" : "drains");
    }
    return exit_done;
}

} // namespace cd
