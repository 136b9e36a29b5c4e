#include "python/cluster.hpp"

#include "client/cluster/fetched_job.hpp"
#include "client/cluster/job_on_master.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/timing/client.hpp"
#include "library/borrowed_poses.hpp"
#include "library/errors.hpp"
#include "library/kept_run.hpp"
#include "library/result_arrays.hpp"
#include "proto/messages/client_messages.hpp"
#include "web/status/job_id.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace cdcluster {

namespace {

template <class T>
T taken(cd::Result<T> result) {
    if (!result) {
        throw ClusterError(result.error());
    }
    return std::move(result.value());
}

void must(const cd::Status& status) {
    if (!status) {
        throw ClusterError(status.error());
    }
}

JobFacts facts_of(const cd::JobStatus& status, std::string id) {
    JobFacts facts;
    facts.id = std::move(id);
    facts.number = status.job.value;
    facts.name = status.name;
    facts.owner = status.turn.owner;
    facts.priority = status.turn.priority;
    facts.state = cd::to_text(status.state);
    facts.failure = status.failure;
    facts.paused = status.paused;
    facts.done = status.summary.merged();
    facts.total = status.summary.total;
    facts.rate = status.scenarios_per_second;
    facts.seconds = status.seconds;
    return facts;
}

JobFacts facts_of(const cd::ConnectedJob& job) {
    return facts_of(job.status, job.id);
}

/// Returns the folder options of results that are fetched.
cd::FolderRunOptions fetched_options(const cd::MasterOptions& master, bool overwrite) {
    cd::FolderRunOptions options;
    options.folder = {overwrite, false, false};
    options.inputs_bytes_max = UINT64_MAX; // The inputs may be nowhere else.
    options.maps_from_master = true;
    options.where.master = master.address;
    options.command = "library";
    return options;
}

} // namespace

std::vector<JobFacts> Cluster::jobs(const cd::StopCheck& stop) const {
    const cd::ConnectedCluster cluster = taken(cd::open_cluster(master_, stop));
    const std::vector<cd::JobId> ids = cd::ids_of(cluster.status.jobs);
    std::vector<JobFacts> jobs;
    for (const cd::JobStatus& status : cluster.status.jobs) {
        jobs.push_back(facts_of(status, cd::job_id_text(status.job, ids)));
    }
    return jobs;
}

JobFacts Cluster::job(const std::string& id, const cd::StopCheck& stop) const {
    return facts_of(taken(cd::open_job(master_, id, stop)));
}

JobFacts
Cluster::send(cd::PreparedJob& job, std::int32_t priority, cd::Connection& connection) const {
    const cd::JobId id = taken(cd::send_job(connection, job, true, priority));
    const cd::ClusterStatus cluster = taken(connection.status());
    const auto status = std::ranges::find(cluster.jobs, id, &cd::JobStatus::job);
    if (status == cluster.jobs.end()) {
        throw ClusterError({cd::ErrorCode::NotFound, "the master does not list the job"});
    }
    return facts_of(*status, cd::job_id_text(id, cd::ids_of(cluster.jobs)));
}

JobFacts Cluster::submit(const Job& job, std::int32_t priority, const cd::StopCheck& stop) const {
    const auto connection = taken(cd::open_master(master_, stop));
    cd::ThreadPool pool;
    cd::PreparedJob prepared = prepare_to_submit(job, tree_cache_, pool);
    cd::make_paths_absolute(prepared);
    return send(prepared, priority, *connection);
}

JobFacts Cluster::submit(const Mesh& a,
                         const Mesh& b,
                         const Poses& poses,
                         const Query& query,
                         const std::string& name,
                         std::int32_t priority,
                         const cd::StopCheck& stop) const {
    const auto connection = taken(cd::open_master(master_, stop));
    cd::PreparedJob job =
        pair_job(a, b, std::make_unique<BorrowedPoses>(poses), poses.form, query, name);
    return send(job, priority, *connection);
}

JobFacts Cluster::set_priority(const std::string& id,
                               std::int32_t priority,
                               const cd::StopCheck& stop) const {
    cd::ConnectedJob job = taken(cd::open_job(master_, id, stop));
    job.status = taken(job.connection->set_priority(job.status.job, priority));
    return facts_of(job);
}

JobFacts Cluster::cancel(const std::string& id, const cd::StopCheck& stop) const {
    cd::ConnectedJob job = taken(cd::open_job(master_, id, stop));
    job.status = taken(job.connection->cancel(job.status.job));
    return facts_of(job);
}

Results Cluster::results(const std::string& id, bool partial, const cd::StopCheck& stop) const {
    cd::ConnectedJob connected = taken(cd::open_job(master_, id, stop));
    if (!partial) {
        must(cd::check_done(connected.status, connected.id));
    }
    auto job = taken(cd::FetchedJob::open(std::move(connected), tree_cache_));
    const cd::PreparedJob& prepared = job.prepared();
    const cd::ExportContext context = cd::export_context(prepared);
    ResultArrays results({}, names_of(context));
    results.number_steps(context);
    const auto report = taken(job.fetch([&](const cd::DoneScenario& done) -> cd::Status {
        results.add(done.result, {});
        return cd::Done{};
    }));
    return results.finish(report.digest, triangles_of(prepared.meshes), report.map);
}

void Cluster::save(const std::string& id,
                   const std::filesystem::path& folder,
                   bool overwrite,
                   const cd::StopCheck& stop) const {
    cd::ConnectedJob connected = taken(cd::open_job(master_, id, stop));
    auto job = taken(cd::FetchedJob::open(std::move(connected), tree_cache_));
    job.prepared().spec.output.dir = folder;
    static_cast<void>(taken(job.write(fetched_options(master_, overwrite), "text")));
}

JobWatch::JobWatch(cd::MasterOptions master, std::string id, cd::StopCheck stop)
    : master_(std::move(master)), id_(std::move(id)), stop_(std::move(stop)) {}

cd::Result<JobFacts> JobWatch::look(std::chrono::milliseconds wait) {
    if (connection_ == nullptr) {
        connection_ = CD_TRY(cd::open_master(master_, stop_));
    }
    CD_TRY(connection_->pause(wait));
    const cd::ClusterStatus cluster = CD_TRY(connection_->status());
    const cd::JobId id = CD_TRY(cd::find_job(id_, cluster.jobs, connection_->owner()));
    const auto status = std::ranges::find(cluster.jobs, id, &cd::JobStatus::job);
    return facts_of(*status, cd::job_id_text(id, cd::ids_of(cluster.jobs)));
}

void JobWatch::open_again() {
    const auto give_up_at = std::chrono::steady_clock::now() + cd::timing::come_back_max;
    for (;;) {
        auto opened = cd::open_master(master_, stop_);
        if (opened) {
            connection_ = std::move(opened.value());
            return;
        }
        if (!cd::is_of_the_network(opened.error()) ||
            std::chrono::steady_clock::now() > give_up_at) {
            throw ClusterError(opened.error());
        }
        const auto next = std::chrono::steady_clock::now() + cd::timing::come_back_period;
        while (std::chrono::steady_clock::now() < next) {
            if (stop_()) {
                throw ClusterError(cd::interrupted());
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
}

JobFacts JobWatch::next(std::chrono::milliseconds wait) {
    const bool was_open = connection_ != nullptr;
    cd::Result<JobFacts> facts = look(wait);
    // A master may come back, and a credential may have been renewed.
    const bool may_help =
        !facts && was_open &&
        (cd::is_of_the_network(facts.error()) || facts.error().code == cd::ErrorCode::Refused);
    if (may_help) {
        open_again();
        facts = look(std::chrono::milliseconds(0));
    }
    return taken(std::move(facts));
}

} // namespace cdcluster
