// The options of cdmaster: from its command line, CDMASTER_* in the environment, and a TOML file.
#pragma once

#include "common/core/limits/master.hpp"
#include "master/jobs/job_retention.hpp"
#include "master/workers/worker_watch.hpp"
#include "proto/channel/channel.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd {

struct MasterConfig {
    Endpoint listen{"127.0.0.1", 7600}; ///< Port 0 lets the system choose one.
    std::filesystem::path state;
    unsigned threads = 0; ///< 0: one for each core.
    bool insecure = false;
    bool check = false;   ///< Look through the state instead of serving.
    bool no_sync = false; ///< For a state that need not survive a loss of power.
    std::string log_level = "info";
    std::string port_file;        ///< Gets the port, for scripts. Empty: none.
    std::optional<Endpoint> http; ///< Where the pages for machines are.
    bool init = false;            ///< Make an identity in the state, and end.
    std::chrono::seconds certificate_life = limits::certificate_life;
    FailureTimes times;
    JobRetention retention; ///< Of jobs that have ended.
};

/// A configuration; or none, with what to print instead (help on stdout, an error on stderr) and
/// the exit code.
struct MasterCommandLine {
    std::optional<MasterConfig> config;
    std::string text;
    int exit_code = 0;
};

/// The command line goes before the environment, which goes before the file of --config.
[[nodiscard]] MasterCommandLine parse_master_command_line(int count, const char* const* arguments);

/// The one line with which a worker joins a master that listens there.
[[nodiscard]] std::string join_line(const Endpoint& listening, bool secured = false);

} // namespace cd
