// A master and its workers on this machine, for as long as the object lives.
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
    std::filesystem::path state;    ///< The master's state; made where it is not there.
    std::filesystem::path logs;     ///< Folder for master.log and worker-N.log.
    unsigned workers = 2;
    unsigned threads = 1; ///< Of each worker.
};

class LocalCluster {
  public:
    /// Returns when the master listens, on a port of loopback that the system chose. The workers
    /// join by themselves. `stopped` ends the waiting with Interrupted.
    /// Errors: NotFound for a missing program; Io; Timeout and Incomplete naming the log.
    [[nodiscard]] static Result<LocalCluster> start(const LocalClusterOptions& options,
                                                    const std::function<bool()>& stopped);

    /// HOST:PORT
    [[nodiscard]] const std::string& address() const { return address_; }

    /// False as soon as one of its programs has ended.
    [[nodiscard]] bool is_running();

    /// Workers first, then the master. The destructor does the same.
    void stop();

    LocalCluster(LocalCluster&&) noexcept = default;
    LocalCluster& operator=(LocalCluster&&) = delete;
    ~LocalCluster();

  private:
    LocalCluster() = default;

    std::string address_;
    std::vector<ChildProcess> processes_; ///< The master first.
};

/// The folder of the running program.
[[nodiscard]] std::filesystem::path program_folder();

} // namespace cd
