#include "client/local/local_cluster.hpp"

#include "common/core/errors.hpp"
#include "common/core/files/state_folder.hpp"
#include "common/core/timing/client.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <thread>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// Reads the port on which cdmaster listens; nothing until its whole line is in the file.
std::optional<std::string> read_port(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line) || file.eof()) {
        return std::nullopt;
    }
    return line.substr(line.rfind(':') + 1);
}

Result<std::string> wait_for_port(ChildProcess& master,
                                  const fs::path& port_file,
                                  const fs::path& log,
                                  const std::function<bool()>& stopped) {
    const auto deadline = std::chrono::steady_clock::now() + timing::local_start_max;
    while (std::chrono::steady_clock::now() < deadline) {
        if (auto port = read_port(port_file)) {
            return *port;
        }
        if (stopped()) {
            return Error{ErrorCode::Interrupted, "interrupted"};
        }
        if (!master.is_running()) {
            return Error{ErrorCode::Incomplete, "cdmaster ended at once; see " + log.string()};
        }
        std::this_thread::sleep_for(timing::process_poll_period);
    }
    return Error{ErrorCode::Timeout, "cdmaster does not listen; see " + log.string()};
}

} // namespace

Result<LocalCluster> LocalCluster::start(const LocalClusterOptions& options,
                                         const std::function<bool()>& stopped) {
    CD_TRY(make_private_folder(options.state));
    std::error_code error;
    fs::create_directories(options.logs, error);
    const fs::path port_file = options.logs / "port";
    fs::remove(port_file, error);
    const fs::path log = options.logs / "master.log";

    LocalCluster cluster;
    auto master =
        CD_TRY(ChildProcess::start(options.programs / "cdmaster",
                                   {"--listen",
                                    "127.0.0.1:0",
                                    "--port-file",
                                    port_file.string(),
                                    "--state",
                                    options.state.string(),
                                    // On loopback a silent worker is dead, so 1 s suffices.
                                    "--return-within",
                                    "1"},
                                   log));
    cluster.processes_.push_back(std::move(master));
    const auto port = CD_TRY(wait_for_port(cluster.processes_.front(), port_file, log, stopped));
    cluster.address_ = "127.0.0.1:" + port;
    for (unsigned i = 1; i <= options.workers; ++i) {
        const std::string name = "worker-" + std::to_string(i);
        auto worker = CD_TRY(ChildProcess::start(options.programs / "cdworker",
                                                 {"--master",
                                                  cluster.address_,
                                                  "--threads",
                                                  std::to_string(options.threads),
                                                  "--name",
                                                  name},
                                                 options.logs / (name + ".log")));
        cluster.processes_.push_back(std::move(worker));
    }
    return cluster;
}

bool LocalCluster::is_running() {
    return std::ranges::all_of(processes_,
                               [](ChildProcess& process) { return process.is_running(); });
}

LocalCluster::~LocalCluster() {
    stop();
}

void LocalCluster::stop() {
    while (!processes_.empty()) {
        processes_.back().stop();
        processes_.pop_back();
    }
}

fs::path program_folder() {
    std::error_code ignored;
    return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

} // namespace cd
