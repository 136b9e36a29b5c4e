#include "client/view/remote_reader.hpp"

#include "client/trees/body_trees.hpp"
#include "common/core/errors.hpp"
#include "common/core/timing/web.hpp"

#include <map>
#include <utility>
#include <vector>

namespace cd {

struct RemoteReader::Latest {
    std::optional<ClusterStatus> status;
    std::chrono::steady_clock::time_point when;
};

RemoteReader::RemoteReader(asio::any_io_executor executor,
                           Connect connect,
                           const std::filesystem::path& tree_cache,
                           unsigned threads)
    : executor_(std::move(executor)),
      connect_(std::move(connect)),
      meshes_(tree_cache),
      trees_(tree_cache),
      building_(threads),
      latest_(std::make_shared<Latest>()) {}

RemoteReader::~RemoteReader() = default;

template <class Ask>
auto RemoteReader::call(const Ask& ask) -> decltype(ask(std::declval<Connection&>())) {
    if (connection_ == nullptr) {
        connection_ = CD_TRY(connect_());
    }
    auto answer = ask(*connection_);
    if (!answer && is_of_the_network(answer.error())) {
        connection_.reset();
    }
    return answer;
}

template <class T, class Ask>
void RemoteReader::post(Take<T> take, Ask ask) {
    thread_.post([this, take = std::move(take), ask = std::move(ask)]() mutable {
        const auto found = std::make_shared<Result<T>>(call(ask));
        asio::post(executor_, [take = std::move(take), found] { take(std::move(*found)); });
    });
}

void RemoteReader::status(Take<ClusterStatus> take) {
    const auto now = std::chrono::steady_clock::now();
    if (latest_->status && now - latest_->when < timing::remote_status_max_age) {
        return take(*latest_->status);
    }
    Take<ClusterStatus> keep = [latest = latest_,
                                take = std::move(take)](const Result<ClusterStatus>& status) {
        if (status) {
            latest->status = status.value();
            latest->when = std::chrono::steady_clock::now();
        }
        take(status);
    };
    post(std::move(keep), [](Connection& connection) { return connection.status(); });
}

void RemoteReader::map(const ContactMapQuery& query, Take<ContactMapAnswer> take) {
    post(std::move(take),
         [query](Connection& connection) { return connection.contact_map(query); });
}

Result<RecordReader> RemoteReader::records(JobId job, std::uint64_t scenarios) {
    return RecordReader([=, this](const ScenarioChoice& choice, const TakeRecord& take) {
        return call([&](Connection& connection) {
            return connection.fetch(query_of<ResultsQuery>(job, choice), scenarios, take);
        });
    });
}

Result<JobDescription> RemoteReader::description(JobId job) {
    if (!description_ || description_->job != job) {
        description_ =
            CD_TRY(call([job](Connection& connection) { return connection.job_description(job); }));
    }
    return *description_;
}

Result<LabelledScenarios> RemoteReader::poses(JobId job, const ScenarioChoice& choice) {
    const std::uint64_t scenarios = CD_TRY(description(job)).submit.scenarios;
    return call([&](Connection& connection) {
        return connection.fetch_poses(query_of<PosesQuery>(job, choice), scenarios);
    });
}

Result<BodyTrees> RemoteReader::trees(const Submit& submit) {
    Meshes hashes;
    for (const JobBody& body : submit.bodies) {
        hashes.push_back(body.mesh);
    }
    if (kept_ && kept_->first == hashes) {
        return kept_->second;
    }
    std::map<Sha256, std::shared_ptr<const Mesh>> known;
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const Sha256& hash : hashes) {
        std::shared_ptr<const Mesh>& mesh = known[hash];
        if (mesh == nullptr) {
            mesh = CD_TRY(
                call([&](Connection& connection) { return get_mesh(connection, hash, meshes_); }));
        }
        meshes.push_back(mesh);
    }
    TreeUse use;
    use.settles = true;
    kept_.emplace(std::move(hashes), make_body_trees(meshes, use, trees_, building_));
    return kept_->second;
}

Result<std::shared_ptr<HttpBody>> RemoteReader::mesh(const Sha256& mesh) {
    const auto found =
        CD_TRY(call([&](Connection& connection) { return get_mesh(connection, mesh, meshes_); }));
    return make_memory_body(found->canonical_bytes());
}

} // namespace cd
