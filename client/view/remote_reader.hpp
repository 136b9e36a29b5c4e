// Reads the jobs of a master for the page, over a connection.
#pragma once

#include "client/remote/connection.hpp"
#include "client/remote/mesh_cache.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/host/thread_pool.hpp"
#include "proto/channel/asio.hpp"
#include "web/server/cluster/cluster_reader.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

/// Connects at the first call, and again after an error of the network.
class RemoteReader final : public ClusterReader {
  public:
    using Connect = std::function<Result<std::unique_ptr<Connection>>()>;

    /// `executor` is the page's. `tree_cache` also keeps meshes; an empty path keeps nothing.
    RemoteReader(asio::any_io_executor executor,
                 Connect connect,
                 const std::filesystem::path& tree_cache,
                 unsigned threads);
    /// Waits for the running call.
    ~RemoteReader() override;

    /// The thread that owns the connection. Members that block are called on it.
    [[nodiscard]] Pool& pool() { return thread_; }

    void status(Take<ClusterStatus> take) override;
    void map(const ContactMapQuery& query, Take<ContactMapAnswer> take) override;
    [[nodiscard]] Result<RecordReader> records(JobId job, std::uint64_t scenarios) override;
    [[nodiscard]] Status may_run() override { return Done{}; }
    [[nodiscard]] Result<JobDescription> description(JobId job) override;
    [[nodiscard]] Result<LabelledScenarios> poses(JobId job, const ScenarioChoice& choice) override;
    [[nodiscard]] Result<BodyTrees> trees(const Submit& submit) override;
    [[nodiscard]] Result<std::shared_ptr<HttpBody>> mesh(const Sha256& mesh) override;

  private:
    /// The last status that the master gave, used on the page's thread.
    struct Latest;
    using Meshes = std::vector<Sha256>; ///< By body.

    /// Calls `ask` with a connection, and drops the connection after an error of the network.
    template <class Ask>
    [[nodiscard]] auto call(const Ask& ask) -> decltype(ask(std::declval<Connection&>()));
    /// Calls `ask` on the pool, and `take` with the outcome on the page's thread.
    template <class T, class Ask>
    void post(Take<T> take, Ask ask);

    asio::any_io_executor executor_;
    Connect connect_;
    MeshCache meshes_;
    TreeCache trees_;
    ThreadPool building_;
    std::unique_ptr<Connection> connection_;
    std::optional<JobDescription> description_;        ///< The one fetched last.
    std::optional<std::pair<Meshes, BodyTrees>> kept_; ///< The trees used last.
    std::shared_ptr<Latest> latest_;
    ThreadPool thread_{1};
};

} // namespace cd
