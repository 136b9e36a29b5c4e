// Runs a master and its workers on this machine for the lifetime of an object.
#pragma once

#include "client/base/child_process.hpp"
#include "common/core/result.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cd {

struct LocalClusterOptions {
    std::filesystem::path programs; ///< The folder of cdmaster and cdworker.
    std::filesystem::path state;    ///< The master's state folder; created if missing.
    std::filesystem::path logs;     ///< Folder for master.log and worker-N.log.
    unsigned workers = 2;
    unsigned threads = 1; ///< Threads per worker.
};

class LocalCluster {
  public:
    /// Starts the programs and returns once the master listens, on a loopback port that the system
    /// chose. The workers join later. Once `stopped` returns true, the call fails with Interrupted.
    /// Errors: NotFound for a missing program; Io; Timeout and Incomplete naming the log.
    [[nodiscard]] static Result<LocalCluster> start(const LocalClusterOptions& options,
                                                    const std::function<bool()>& stopped);

    /// Returns the master's address, HOST:PORT.
    [[nodiscard]] const std::string& address() const { return address_; }

    /// False once the master or a worker has ended.
    [[nodiscard]] bool is_running();

    /// Stops the workers, then the master. The destructor calls it too.
    void stop();

    LocalCluster(LocalCluster&&) noexcept = default;
    LocalCluster& operator=(LocalCluster&&) = delete;
    ~LocalCluster();

  private:
    LocalCluster() = default;

    std::string address_;
    std::vector<ChildProcess> processes_; ///< The master, then the workers.
};

/// Returns the folder of the running program.
[[nodiscard]] std::filesystem::path program_folder();

} // namespace cd
