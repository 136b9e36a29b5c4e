#include "master/run_master.hpp"

#include "common/core/limits.hpp"
#include "common/core/log.hpp"
#include "common/core/thread_pool.hpp"
#include "master/coordinator.hpp"
#include "master/geometry_store.hpp"
#include "master/server.hpp"
#include "proto/signals.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace cd {

namespace {

constexpr unsigned blocking_threads = 4;

/// Whole or not at all: a script may be waiting for the file.
Status write_port(const std::string& path, std::uint16_t port) {
    const std::string unfinished = path + ".new";
    std::ofstream file(unfinished);
    file << port << '\n';
    file.close();
    std::error_code error;
    if (file) {
        std::filesystem::rename(unfinished, path, error);
    }
    if (!file || error) {
        return Error{ErrorCode::Io, "cannot write the port to '" + path + "'"};
    }
    return Done{};
}

/// Connections and the results of jobs are a file each.
void allow_many_files() {
    rlimit files{};
    if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
        files.rlim_cur = files.rlim_max;
        (void)setrlimit(RLIMIT_NOFILE, &files); // Fewer will do for fewer jobs.
    }
}

} // namespace

Status run_master(const MasterConfig& config) {
    if (Status exposed = check_exposure(config.listen, {false, config.insecure, true}); !exposed) {
        return exposed;
    }
    // A full disk or a limit of files is an error to wait with, not a reason to be killed.
    std::signal(SIGXFSZ, SIG_IGN);
    allow_many_files();
    // What is declared first ends last: whatever runs on the pools may post to the context.
    asio::io_context context(1);
    ThreadPool compute(config.threads);
    auto geometry = GeometryStore::open(config.state, compute);
    if (!geometry) {
        return geometry.error();
    }
    auto journal = Journal::open({config.state, !config.no_sync});
    if (!journal) {
        return journal.error();
    }
    ThreadPool blocking(blocking_threads);
    Coordinator coordinator({context.get_executor(),
                             *geometry.value(),
                             compute,
                             blocking,
                             *journal.value(),
                             config.state / "jobs",
                             config.no_sync ? Durability::Unsynced : Durability::Synced});
    if (Status restored = coordinator.restore(journal.value()->take_recovered()); !restored) {
        return restored;
    }
    const auto server = Server::listen(context.get_executor(), config.listen, coordinator);
    if (!server) {
        return server.error();
    }
    const std::uint16_t port = server.value()->port();
    bool stopping = false;
    StopSignals signals(context.get_executor(), [&](unsigned) {
        stopping = true;
        server.value()->close();
        signals.cancel();
    });
    // Who waits for the file may send a signal as soon as it is there.
    if (!config.port_file.empty()) {
        if (Status written = write_port(config.port_file, port); !written) {
            return written;
        }
    }
    server.value()->start();
    spdlog::info(
        "listening: host={} port={} state={}", config.listen.host, port, config.state.string());
    std::printf("%s\n", join_line({config.listen.host, port}).c_str());
    std::fflush(stdout);

    while (!stopping) {
        context.run_one();
    }
    // Sessions end now; what a pool is busy with is not waited for any longer than this.
    context.run_for(limits::stop_grace);
    spdlog::info("ended");
    return Done{};
}

} // namespace cd
