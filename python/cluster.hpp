// A cluster, for the Python package: jobs on a master, and their results.
#pragma once

#include "client/cli/cli.hpp"
#include "client/job/prepared_job.hpp"
#include "client/remote/connection.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cdcluster {

/// A failure of a master, or of the way to it.
class ClusterError : public std::runtime_error {
  public:
    explicit ClusterError(const cd::Error& error)
        : std::runtime_error(error.detail), code_(error.code) {}
    [[nodiscard]] cd::ErrorCode code() const { return code_; }

  private:
    cd::ErrorCode code_;
};

/// What a master tells of a job.
struct JobFacts {
    std::string id; ///< "j-4f2a"
    std::uint64_t number = 0;
    std::string name;
    std::string owner;
    std::int32_t priority = 0;
    std::string state;   ///< running, done, cancelled or failed.
    std::string failure; ///< Why the job failed; else empty.
    std::string paused;  ///< Why the job is paused; else empty.
    std::uint64_t done = 0;
    std::uint64_t total = 0;
    double rate = 0; ///< Scenarios a second.
    double seconds = 0;
};

/// A master. Each call connects anew, so that nothing is open between calls: any number of threads
/// may call at once, and a process may fork. A call throws ClusterError with Interrupted soon after
/// its `stop` returns true.
class Cluster {
  public:
    /// `tree_cache` is the folder that keeps fetched meshes; empty: none.
    Cluster(cd::MasterOptions master, std::filesystem::path tree_cache)
        : master_(std::move(master)), tree_cache_(std::move(tree_cache)) {}

    [[nodiscard]] const cd::MasterOptions& master() const { return master_; }

    [[nodiscard]] std::vector<JobFacts> jobs(const cd::StopCheck& stop) const;
    /// Finds a job by its id, a prefix of it, its number, or "last".
    [[nodiscard]] JobFacts job(const std::string& id, const cd::StopCheck& stop) const;

    /// `priority`: -10 to 10; jobs of higher priority go first.
    [[nodiscard]] JobFacts
    submit(const Job& job, std::int32_t priority, const cd::StopCheck& stop) const;
    /// Submits a question about two meshes. An empty name stands for that of `cdctl`.
    [[nodiscard]] JobFacts submit(const Mesh& a,
                                  const Mesh& b,
                                  const Poses& poses,
                                  const Query& query,
                                  const std::string& name,
                                  std::int32_t priority,
                                  const cd::StopCheck& stop) const;
    /// Changes the priority of a job that has not ended.
    [[nodiscard]] JobFacts
    set_priority(const std::string& id, std::int32_t priority, const cd::StopCheck& stop) const;
    /// Cancels a job unless it has ended.
    [[nodiscard]] JobFacts cancel(const std::string& id, const cd::StopCheck& stop) const;

    /// Fetches the results of a job that has ended. Errors: Incomplete if scenarios have none, and
    /// `partial` is not set.
    [[nodiscard]] Results
    results(const std::string& id, bool partial, const cd::StopCheck& stop) const;
    /// Fetches a job into a folder, as `cdctl results --out` does. Errors: as those of
    /// `FetchedJob`.
    void save(const std::string& id,
              const std::filesystem::path& folder,
              bool overwrite,
              const cd::StopCheck& stop) const;

  private:
    [[nodiscard]] JobFacts
    send(cd::PreparedJob& job, std::int32_t priority, cd::Connection& connection) const;

    cd::MasterOptions master_;
    std::filesystem::path tree_cache_;
};

/// Looks at a job again and again on one connection, which it opens again when it is lost.
class JobWatch {
  public:
    /// `stop` is polled by all calls.
    JobWatch(cd::MasterOptions master, std::string id, cd::StopCheck stop);

    /// Waits, and returns what the master tells then. Errors: Disconnected if the master stays away
    /// for a minute.
    [[nodiscard]] JobFacts next(std::chrono::milliseconds wait);

  private:
    [[nodiscard]] cd::Result<JobFacts> look(std::chrono::milliseconds wait);
    void open_again();

    cd::MasterOptions master_;
    std::string id_;
    cd::StopCheck stop_;
    std::unique_ptr<cd::Connection> connection_; ///< Null until the first look.
};

} // namespace cdcluster
