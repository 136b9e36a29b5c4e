// The verbs that maintain a cluster: removing jobs and meshes, draining workers.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/remote_session.hpp"
#include "common/core/errors.hpp"
#include "web/status/job_id.hpp"
#include "web/status/table.hpp"

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

/// Finds a job by its id, or a mesh by four or more first digits of its hash. Errors: NotFound;
/// BadInput if several jobs or meshes begin with these digits.
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
        return bad_input(std::to_string(meshes.size()) + " meshes begin with '" + text + "'");
    }
    if (meshes.size() == 1 && job.error().code == ErrorCode::NotFound) {
        return Removable{meshes.front()->mesh,
                         "mesh " + to_short_hex(meshes.front()->mesh) + " " + meshes.front()->name};
    }
    return job.error();
}

/// Finds a worker by its id ("w-3") or name; lost workers are ignored. Errors: NotFound; BadInput
/// if several workers have the name.
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
        return bad_input(std::to_string(named.size()) + " workers are called '" + text +
                         "'; name one by its id, see `cdctl get workers`");
    }
    if (named.empty()) {
        return Error{ErrorCode::NotFound,
                     "no worker '" + text + "' is here; see `cdctl get workers`"};
    }
    return named.front();
}

} // namespace

Result<int> perform(const RemoveCommand& command) {
    const InterruptGuard interrupts;
    const auto [connection, status] = CD_TRY(open_cluster(command.master));
    std::vector<Removable> targets;
    for (const std::string& text : command.what) {
        targets.push_back(CD_TRY(find_removable(status, text, connection->owner())));
    }
    if (!command.yes) {
        for (const Removable& target : targets) {
            std::fprintf(stderr, "cdctl: %s would be removed for good\n", target.name.c_str());
        }
        return bad_input("nothing was removed; add --yes");
    }
    for (const auto& [what, name] : targets) {
        const auto* job = std::get_if<JobId>(&what);
        const Result<Removed> removed = job != nullptr
                                            ? connection->remove_job(*job, command.cancel)
                                            : connection->remove_mesh(std::get<Sha256>(what));
        if (!removed) {
            return Error{removed.error().code, name + ": " + removed.error().detail};
        }
        const std::string freed = cell_text(removed.value().bytes, CellKind::Size);
        std::printf("%s removed, %s freed\n", name.c_str(), freed.c_str());
    }
    return exit_done;
}

Result<int> perform(const DrainCommand& command) {
    if (command.all == !command.workers.empty()) {
        return bad_input("name the workers to drain, or say --all");
    }
    const InterruptGuard interrupts;
    const auto [connection, status] = CD_TRY(open_cluster(command.master));
    DrainWorkers wish;
    wish.now = command.now;
    for (const std::string& text : command.workers) {
        wish.workers.push_back(CD_TRY(find_worker(status, text)));
    }
    const Draining told = CD_TRY(connection->drain(wish));
    for (const WorkerId worker : told.workers) {
        std::printf("w-%llu %s\n",
                    static_cast<unsigned long long>(worker.value),
                    command.now ? "ends" : "drains");
    }
    return exit_done;
}

} // namespace cd
